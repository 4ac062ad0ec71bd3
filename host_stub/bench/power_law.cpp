// Fits a straight line to logarithms by least squares; its slope is the exponent.
#include "bench/power_law.h"

#include <cmath>
#include <cstddef>

namespace burin {

PowerLaw fit_power_law(std::span<const double> sizes, std::span<const double> costs) {
  const auto count = static_cast<double>(sizes.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    mean_x += std::log(sizes[i]) / count;
    mean_y += std::log(costs[i]) / count;
  }
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double x = std::log(sizes[i]) - mean_x, y = std::log(costs[i]) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double exponent = xy / xx;
  const double residual = std::fmax(yy - exponent * xy, 0);
  const double error = sizes.size() > 2 ? std::sqrt(residual / (count - 2) / xx) : 0;
  return {exponent, std::exp(mean_y - exponent * mean_x), error};
}

}  // namespace burin
