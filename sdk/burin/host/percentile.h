#pragma once
#include <span>

namespace burin {

/// Figures of many measurements, in their unit.
struct Percentiles {
  double p50 = 0, p95 = 0, p99 = 0, max = 0;
};

/// By nearest rank: the smallest value that at least the given share of all values does not exceed.
/// All 0 where there are no values.
Percentiles percentiles(std::span<const double> values);

}  // namespace burin
