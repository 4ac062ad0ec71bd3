#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/curve/tangent_turn.h>

#include <cstddef>
#include <vector>

namespace burin {

/// Geodesic curvature of a surface curve at its points, 1 / length, positive where it bends to the left.
///
/// The estimate is the slope, at the point, of a least-squares cubic fitted to the angle by which the tangent
/// turns against parallel transport, over the points within `window` of arc length on either side. This
/// averages out the noise of the samples; the bias is of third order in the window. Near the ends of an open
/// curve the window shrinks with the distance to the end, down to half, and a parabola replaces the cubic
/// where the window would still reach beyond the end. No window reaches across a corner (a turn of more than
/// 0.5 radians between neighbouring points) or far beyond 0.7 radians of turn, so that bends tighter than the
/// window keep their curvature; where it sees more than 0.35 radians of turn the fit is a straight line. If
/// 128 or more points of an open curve lie on one side, only every second, third, ... point is used.
class GeodesicCurvature {
 public:
  /// Updates the estimates after a change of the curve from this point on (0: the whole curve). Returns the
  /// first point whose curvature was estimated again.
  std::size_t update(const SurfaceCurve& curve, double window, std::size_t first_changed = 0);

  float operator[](std::size_t point) const { return curvature_[point]; }
  const std::vector<float>& values() const { return curvature_; }

 private:
  float slope_at(const SurfaceCurve& curve, double window, std::size_t point) const;

  TangentTurn turn_;
  std::vector<float> curvature_;
};

}  // namespace burin
