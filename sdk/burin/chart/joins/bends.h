#pragma once
#include <burin/stroke/curve/geodesic_curvature.h>
#include <burin/stroke/curve/surface_curve.h>

#include <span>
#include <vector>

namespace burin {

/// A part of the stroke whose geodesic curvature is above 1 / radius. Arc lengths are in object units.
struct Bend {
  double begin, middle, end;  ///< begin to end holds 96 % of the turn; half of it comes before the middle
  double turn;                ///< radians, left positive
  bool operator==(const Bend&) const = default;
};

/// Finds the bends of a stroke that are sharper than its radius, and measures how far the stroke turns
/// between two arc lengths.
class StrokeBends {
 public:
  void update(const SurfaceCurve& curve, const GeodesicCurvature& curvature, double radius);

  /// The bends in the order of t. On a closed stroke the first one may begin below 0 and the last one may end
  /// beyond the length.
  std::span<const Bend> all() const { return bends_; }

  /// The angle by which the tangent turns against parallel transport from the arc length `from` to `to`,
  /// radians, left positive.
  double turn(double from, double to) const { return angle_at(to) - angle_at(from); }

 private:
  double angle_at(double t) const;
  double reached(const Bend& bend, double share) const;

  std::vector<double> t_, angles_;  ///< [point of the curve] arc length, turn since the start
  double length_ = 0, loop_angle_ = 0;
  bool closed_ = false;
  std::vector<Bend> bends_;
};

}  // namespace burin
