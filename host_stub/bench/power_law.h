#pragma once
#include <span>

namespace burin {

/// cost = factor * size^exponent.
struct PowerLaw {
  double exponent = 0, factor = 0;
  double standard_error = 0;  ///< of the exponent; 0 for two points
};

/// Least squares of log cost over log size. Sizes and costs are positive, at least two sizes differ.
PowerLaw fit_power_law(std::span<const double> sizes, std::span<const double> costs);

}  // namespace burin
