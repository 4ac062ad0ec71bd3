#pragma once
#include <span>

namespace burin {

/// Percentiles of a set of measurements, in the unit of these.
struct Percentiles {
  double p50 = 0, p95 = 0, p99 = 0, max = 0;
};

/// Computes percentiles by nearest rank: the smallest value such that at least the given share of all values
/// does not exceed it. All are 0 if there are no values.
Percentiles percentiles(std::span<const double> values);

}  // namespace burin
