#pragma once
#include <burin/math/elementary.h>
#include <burin/stroke/pen_angles.h>

namespace burin {

/// Sets the tilt of a pen whose upper end points to `azimuth`, from +x towards +y, and `altitude` above the
/// plane, both in radians.
inline void set_tilt(Pen& pen, double azimuth, double altitude) {
  const double level = math::cos(altitude);
  set_upper_end(pen, {level * math::cos(azimuth), level * math::sin(azimuth), math::sin(altitude)});
}

}  // namespace burin
