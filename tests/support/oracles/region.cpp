#include "region.h"

#include <algorithm>

namespace burin::test {
namespace {

void make_set(std::vector<Index>& items) {
  std::ranges::sort(items);
  items.erase(std::ranges::unique(items).begin(), items.end());
}

}  // namespace

Index local_index(const std::vector<Index>& ascending, Index of_surface) {
  const auto found = std::ranges::lower_bound(ascending, of_surface);
  if (found == ascending.end() || *found != of_surface) return no_index;
  return static_cast<Index>(found - ascending.begin());
}

Region make_region(const Surface& surface, std::vector<Index> triangles) {
  make_set(triangles);
  Region region;
  region.triangles = std::move(triangles);
  for (const Index triangle : region.triangles) {
    const Triangle& corners = surface.triangles[triangle];
    region.vertices.insert(region.vertices.end(), corners.begin(), corners.end());
  }
  make_set(region.vertices);
  for (const Index triangle : region.triangles) {
    const auto& [a, b, c] = surface.triangles[triangle];
    region.corners.push_back(
        {local_index(region.vertices, a), local_index(region.vertices, b), local_index(region.vertices, c)});
  }
  return region;
}

Region region_around(const Surface& surface, std::span<const SurfacePoint> points, double reach) {
  const auto squared = static_cast<float>(reach * reach);
  std::vector<bool> seen(surface.vertex_count());
  std::vector<Index> found;
  const auto visit = [&](Index vertex) {
    if (seen[vertex]) return;
    seen[vertex] = true;
    const Vec3f& place = surface.positions[vertex];
    const auto is_near = [&](const SurfacePoint& p) { return (p.position - place).squaredNorm() <= squared; };
    if (std::ranges::any_of(points, is_near)) found.push_back(vertex);
  };
  for (const SurfacePoint& point : points) std::ranges::for_each(point.corners, visit);
  for (std::size_t next = 0; next < found.size();)
    std::ranges::for_each(surface.neighbours[found[next++]], visit);
  std::vector<Index> triangles;
  for (const Index vertex : found) {
    const auto around = surface.incident[vertex];
    triangles.insert(triangles.end(), around.begin(), around.end());
  }
  return make_region(surface, std::move(triangles));
}

}  // namespace burin::test
