#pragma once
#include <span>
#include <vector>

namespace burin {

/// A value with a weight, >= 0.
struct WeightedValue {
  double value = 0, weight = 0;
};

/// The smoothing spline of offsets from a curve at equidistant points of it (Whittaker 1923), as snakes fit
/// it: the x that make the sum of weight_i (x_i - value_i)^2 + stiffness (x_(i-1) - 3 x_i + 3 x_(i+1) -
/// x_(i+2) + bend_i - bend_(i+1))^2 least. bend_i is the second difference of the curve itself, in the
/// direction of the offsets, so that it is the moved curve that gets smooth, not its difference from one that
/// need not be. With unit weights waves shorter than 2 pi stiffness^(1/6) steps are flattened; arcs stay, at
/// the ends too. The weights must not all be 0. O(n) for n values.
std::vector<double> smooth_offsets(std::span<const WeightedValue> values, std::span<const double> bends,
                                   double stiffness);

}  // namespace burin
