// Computes percentiles of sorted measurements by nearest rank, in O(n log n).
#include <burin/host/percentile.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin {
namespace {

/// Whole percents, so that the rank is exact.
double nearest_rank(const std::vector<double>& sorted, std::size_t percent) {
  const std::size_t rank = (sorted.size() * percent + 99) / 100;
  return sorted[rank - 1];
}

}  // namespace

Percentiles percentiles(std::span<const double> values) {
  if (values.empty()) return {};
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return {nearest_rank(sorted, 50), nearest_rank(sorted, 95), nearest_rank(sorted, 99), sorted.back()};
}

}  // namespace burin
