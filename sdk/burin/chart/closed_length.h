#pragma once
#include <cmath>

namespace burin {

/// An arc length of a closed stroke of this length brought to [0, length); as it is when there is no length.
inline double wrapped_t(double t, double length) {
  if (!(length > 0)) return t;
  const double rest = t - length * std::floor(t / length);
  return rest < length ? rest : 0;
}

/// The turn of it that is nearest to another arc length.
inline double t_nearest_to(double near, double t, double length) {
  return length > 0 ? t - length * std::round((t - near) / length) : t;
}

}  // namespace burin
