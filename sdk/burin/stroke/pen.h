#pragma once
#include <burin/base/vector.h>

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

/// Pen and stroke where the arc length is t; in caps beyond the ends of an open stroke, those of the end.
struct PenAt {
  Pen pen;
  double time = 0;                                        ///< seconds since the first sample
  double speed = 0;                                       ///< object units a second, as CurvePoint::speed
  float width = 1;                                        ///< as CurvePoint::width
  double t = 0;                                           ///< within the curve, object units
  Vec3f tangent = Vec3f::Zero(), normal = Vec3f::Zero();  ///< of the curve; directions, not unit
};

}  // namespace burin
