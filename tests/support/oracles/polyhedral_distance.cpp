#include "polyhedral_distance.h"

#include <algorithm>
#include <cmath>

namespace burin::test {

std::optional<std::vector<double>> polyhedral_distances(const Surface& surface, const Region& region,
                                                        const SurfacePoint& from) {
  const Index triangle = local_index(region.triangles, from.triangle);
  Unfolding unfolding(surface, region);
  if (triangle == no_index || !unfolding.is_manifold()) return std::nullopt;
  unfolding.find_from(triangle, from);
  return unfolding.distances();
}

PolylineDistance::PolylineDistance(const Surface& surface, const Region& region,
                                   std::span<const SurfacePoint> points)
    : region_(region), unfolding_(surface, region) {
  unfolding_.aim_at(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    lengths_.push_back((points[i + 1].position - points[i].position).cast<double>().norm());
}

PolylineDistance::Nearest PolylineDistance::from(Index vertex, double most) {
  const double longest = lengths_.empty() ? 0 : std::ranges::max(lengths_);
  unfolding_.find_from(local_index(region_.vertices, vertex), most + longest, 1.01 * longest);
  const std::vector<double>& reached = unfolding_.reached();
  const auto least = std::ranges::min_element(reached);
  Nearest nearest{*least, static_cast<double>(least - reached.begin())};
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    const double a = reached[i], b = reached[i + 1], length = lengths_[i];
    if (!(a < unreached && b < unreached && length > 0)) continue;
    const double along = (a * a + length * length - b * b) / (2 * length);
    const double height = std::sqrt(std::max(0., a * a - along * along));
    if (along > 0 && along < length && height < nearest.distance)
      nearest = {height, static_cast<double>(i) + along / length};
  }
  return nearest;
}

}  // namespace burin::test
