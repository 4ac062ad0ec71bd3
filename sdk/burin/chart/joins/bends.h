#pragma once
#include <burin/stroke/curve/geodesic_curvature.h>
#include <burin/stroke/curve/surface_curve.h>

#include <span>
#include <vector>

namespace burin {

/// A part of the stroke that bends sharper than its radius. Arc lengths, object units.
struct Bend {
  double begin, middle, end;  ///< nearly all of the turn lies between; half of it before the middle
  double turn;                ///< radians, left positive
};

/// Where a stroke bends sharper than its radius, and by how much it has turned.
class StrokeBends {
 public:
  void update(const SurfaceCurve& curve, const GeodesicCurvature& curvature, double radius);

  /// In the order of t. On a closed stroke the first one may begin below 0 and the last one end beyond the
  /// length.
  std::span<const Bend> all() const { return bends_; }

  /// By which the tangent has turned from the arc length `from` to `to`, against parallel transport, radians.
  double turn(double from, double to) const { return angle_at(to) - angle_at(from); }

 private:
  double angle_at(double t) const;
  double reached(const Bend& bend, double share) const;

  std::vector<double> t_, angles_;  ///< of the curve's points
  double length_ = 0, loop_angle_ = 0;
  bool closed_ = false;
  std::vector<Bend> bends_;
};

}  // namespace burin
