#pragma once
#include <span>

namespace burin {

/// The law cost = factor * size^exponent.
struct PowerLaw {
  double exponent = 0, factor = 0;
  double standard_error = 0;  ///< standard error of the exponent; 0 for two points
};

/// Fits the law by least squares of log cost over log size. Sizes and costs must be positive, and at least
/// two sizes must differ.
PowerLaw fit_power_law(std::span<const double> sizes, std::span<const double> costs);

}  // namespace burin
