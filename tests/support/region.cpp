#include "support/region.h"

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

}  // namespace burin::test
