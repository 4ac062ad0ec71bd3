#pragma once
#include <burin/stroke/curve/surface_curve.h>

#include <cstddef>
#include <vector>

namespace burin {

/// Geodesic curvature of a surface curve at its points, 1 / length, positive where it bends to the left.
///
/// Estimated from the angle by which the tangent has turned against parallel transport: the slope, at the
/// point, of the least-squares cubic through the angles over the points within `window` of arc length on
/// either side. So the noise of the samples averages out, while only the curvature's own third order over the
/// window biases it. Near the ends of an open curve the window shrinks with the distance to the end, to no
/// less than half, and a parabola serves where it reaches over the end. No window reaches over a corner, a
/// turn of more than half a radian between neighbouring points, nor much beyond 0.7 radians of turn, so that
/// bends tighter than the window keep their curvature. Where more than some hundred points lie on a side of
/// it, only every so many count.
class GeodesicCurvature {
 public:
  /// Follows a change of the curve from this point on (0: all of it). Returns the first point whose curvature
  /// was estimated anew.
  std::size_t update(const SurfaceCurve& curve, double window, std::size_t first_changed = 0);

  float operator[](std::size_t point) const { return curvature_[point]; }
  const std::vector<float>& values() const { return curvature_; }

  /// The angle by which the tangent has turned from the first point to this one, radians, left positive.
  double turned(std::size_t point) const { return angles_[point]; }

  /// The same all around a closed curve, back to its first point.
  double loop_angle() const { return angles_.empty() ? 0 : angles_.back() + closing_angle_; }

 private:
  void turn(const SurfaceCurve& curve, std::size_t first_changed);
  float slope_at(const SurfaceCurve& curve, double window, std::size_t point) const;

  std::vector<double> angles_;  ///< by which the tangent has turned since the first point, radians
  double closing_angle_ = 0;    ///< from the last point to the first of a closed curve
  std::vector<float> curvature_;
};

}  // namespace burin
