#pragma once
#include <cmath>
#include <numbers>

namespace burin::test {

/// A relief that is narrow compared with a brush: the height over (x, y), all in radii of the brush, with a
/// root mean square of one half.
using Relief = double (*)(double x, double y);

/// Waves of 0.35 radii along x and along y.
inline double egg_crate(double x, double y) {
  const double k = 2 * std::numbers::pi / 0.35;
  return std::sin(k * x) * std::sin(k * y);
}

/// Waves of 0.25 to 0.45 radii in all directions.
inline double band_noise(double x, double y) {
  constexpr int waves = 64;
  // Steps of the golden ratio and its generalisations to two and three dimensions fill the unit interval
  // evenly.
  const auto share = [](int i, double step) { return i * step - std::floor(i * step); };
  double sum = 0;
  for (int i = 1; i <= waves; ++i) {
    const double k = 2 * std::numbers::pi / (0.25 + 0.2 * share(i, 0.8191725133961645));
    const double along = 2 * std::numbers::pi * share(i, 0.6710436067037893);
    const double phase = 2 * std::numbers::pi * share(i, 0.5497004779019703);
    sum += std::sin(k * (std::cos(along) * x + std::sin(along) * y) + phase);
  }
  return sum / std::sqrt(2. * waves);
}

}  // namespace burin::test
