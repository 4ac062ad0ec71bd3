#pragma once
#include <burin/base/vector.h>

namespace burin {

/// What the pen reports beside its position. Fields that the pen does not report have the neutral values
/// given here.
struct Pen {
  float pressure = 1;            ///< 0..1
  float tilt_x = 0, tilt_y = 0;  ///< radians from upright
  float twist = 0;               ///< radians
};

/// The fields that a pen reports; a mouse has no pressure.
struct PenFields {
  bool time = false;
  bool pressure = false;
  bool tilt = false;
  bool twist = false;
  bool barrel = false;  ///< whether a button at its side is held; only recordings keep it

  bool operator==(const PenFields&) const = default;
};

/// Pen and curve at the arc length t. In the caps beyond the ends of an open stroke they are those of the
/// end.
struct PenAt {
  Pen pen;
  double time = 0;                                        ///< seconds since the first sample
  double speed = 0;                                       ///< CurvePoint::speed, object units per second
  float width = 1;                                        ///< CurvePoint::width
  double t = 0;                                           ///< clamped to the curve, object units
  Vec3f tangent = Vec3f::Zero(), normal = Vec3f::Zero();  ///< of the curve; not normalised
};

}  // namespace burin
