#include <burin/surface/weld.h>
#include <oneapi/tbb/parallel_sort.h>

#include <numeric>
#include <tuple>

namespace burin {

std::vector<Index> first_at_place(std::span<const Vec3f> points) {
  const auto key = [&](Index i) { return std::tuple(points[i].x(), points[i].y(), points[i].z(), i); };
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  tbb::parallel_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });

  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace burin
