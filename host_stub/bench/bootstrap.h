#pragma once
#include <span>

namespace burin {

/// A figure and the interval that holds it with 95 % confidence.
struct Estimate {
  double low = 0, value = 0, high = 0;
};

/// Geometric mean of positive ratios, each of one pair of runs, with the percentile interval of 10000
/// bootstrap samples that draw as many pairs with replacement [Efron & Tibshirani 1993, ch. 13]. The same
/// ratios give the same estimate. Pairs are drawn, not events: events of one run are not independent.
Estimate bootstrap_mean_ratio(std::span<const double> ratios);

}  // namespace burin
