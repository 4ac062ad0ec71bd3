#pragma once
#include <span>

namespace burin {

/// A value with its 95 % confidence interval.
struct Estimate {
  double low = 0, value = 0, high = 0;
};

/// The geometric mean of positive ratios, one per pair of runs, with the percentile interval of 10000
/// bootstrap samples [Efron & Tibshirani 1993, ch. 13]. Samples draw pairs of runs with replacement, not
/// events, since the events of one run are not independent. The same ratios give the same estimate.
Estimate bootstrap_mean_ratio(std::span<const double> ratios);

}  // namespace burin
