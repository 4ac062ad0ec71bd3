#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/curve/tangent_turn.h>

#include <cstddef>
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
  /// Goes over to this curve, whose first `unchanged` points are those of the last call, with the same
  /// radius. Costs O(1) per point and step that changed.
  void update(const SurfaceCurve& curve, double radius, std::size_t unchanged = 0);

  /// The bends in the order of t. On a closed stroke the first one may begin below 0 and the last one may end
  /// beyond the length.
  std::span<const Bend> all() const { return bends_; }

  /// The angle by which the tangent turns against parallel transport from the arc length `from` to `to`,
  /// radians, left positive.
  double turn(double from, double to) const { return angle_at(to) - angle_at(from); }

 private:
  double angle_at(double t) const;
  double reached(const Bend& bend, double share) const;
  double sharpness(long step) const;
  long drop_changed(double unchanged_t);
  void find(long from);
  Bend measured(double begin, double end) const;

  TangentTurn angles_;
  std::vector<double> t_;  ///< [point of the curve] arc length
  double length_ = 0;
  bool closed_ = false;
  double window_ = 0, step_ = 0;  ///< object units
  std::vector<Bend> bends_;
  std::vector<long> ends_;  ///< [bend] the first step after it
};

}  // namespace burin
