#pragma once
#include <algorithm>
#include <cmath>

namespace burin {

/// The distance of the arc length t beyond the ends of an open stroke of this length, object units, >= 0; 0
/// on a closed stroke.
inline double beyond_ends(double t, double length, bool closed) {
  return closed ? 0 : std::max({-t, t - length, 0.});
}

/// Reduces an arc length of a closed stroke to [0, length). Without a length it stays unchanged.
inline double wrapped_t(double t, double length) {
  if (!(length > 0)) return t;
  const double rest = t - length * std::floor(t / length);
  return rest < length ? rest : 0;
}

/// Adds the multiple of a closed stroke's length to t that brings it nearest to `near`.
inline double t_nearest_to(double near, double t, double length) {
  return length > 0 ? t - length * std::round((t - near) / length) : t;
}

}  // namespace burin
