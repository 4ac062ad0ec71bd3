#pragma once
#include <algorithm>
#include <cmath>

namespace burin {

/// How far beyond the ends of an open stroke of this length an arc length lies, object units, >= 0; 0 on a
/// closed one.
inline double beyond_ends(double t, double length, bool closed) {
  return closed ? 0 : std::max({-t, t - length, 0.});
}

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
