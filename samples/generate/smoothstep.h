#pragma once
#include <algorithm>

namespace burin::samples {

/// Rises from 0 at x = 0 to 1 at x = 1, with slopes of 0 there.
inline double smoothstep(double x) {
  const double s = std::clamp(x, 0., 1.);
  return s * s * (3 - 2 * s);
}

}  // namespace burin::samples
