// Finds equal positions by sorting the bits of their coordinates. Equal ones are ordered by index, so that
// the result does not depend on the number of threads.
#include <burin/base/parallel.h>
#include <burin/surface/topology/weld.h>

#include <array>
#include <bit>
#include <numeric>
#include <utility>

namespace burin {
namespace {

using Place = std::array<std::uint32_t, 3>;

/// The bits of the coordinates, with -0 as 0. They order all floats, including the NaNs of a damaged file.
Place place_of(const Vec3f& point) {
  const auto bits = [](float coordinate) { return std::bit_cast<std::uint32_t>(coordinate + 0.0f); };
  return {bits(point.x()), bits(point.y()), bits(point.z())};
}

}  // namespace

std::vector<Index> first_at_position(std::span<const Vec3f> points) {
  const auto key = [&](Index i) { return std::pair(place_of(points[i]), i); };
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  parallel_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });

  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && place_of(points[order[i]]) == place_of(points[order[i - 1]]);
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace burin
