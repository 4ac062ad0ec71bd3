#pragma once
#include <cstdint>

namespace burin {

/// What the pen reports beyond its place. Fields that a recorder lacks hold the neutral values here.
struct Pen {
  float pressure = 1;            ///< 0..1
  float tilt_x = 0, tilt_y = 0;  ///< radians from upright
  float twist = 0;               ///< radians
};

/// Which fields a recording really has; a mouse has no pressure.
struct PenFields {
  bool time = false;
  bool pressure = false;
  bool tilt = false;
  bool twist = false;

  bool operator==(const PenFields&) const = default;
};

}  // namespace burin
