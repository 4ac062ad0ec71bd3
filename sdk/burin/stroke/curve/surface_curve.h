#pragma once
#include <burin/stroke/curve.h>
#include <burin/stroke/curve/curve_ground.h>
#include <burin/stroke/curve/pen_spline.h>
#include <burin/stroke/curve/pen_way.h>
#include <burin/stroke/dynamics.h>
#include <burin/stroke/recording.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Turns the samples of one stroke into its surface curve as they arrive. Between two samples the curve
/// follows the centripetal Catmull-Rom spline of the samples, brought onto the surface by closest points;
/// time and pen follow monotone cubics, which stay between the samples' values. What a pen at rest trembles,
/// or a slow one creeps, is left out as PenWay tells. The curve depends on the ground, the samples so far and
/// the radius only, not on when it was asked for: the part up to the last sample but one that stays is final,
/// the rest is replaced by the next add(). Samples are places on the ground, or points of the surface. One
/// thread.
class CurveTracer {
 public:
  /// `radius`: of the stroke, object units. Points are half an edge apart, but at least radius / 1000 and
  /// at most radius / 8.
  CurveTracer(const CurveGround& ground, double radius, StrokeWidth width = {});
  CurveTracer(const Surface& surface, const Picker& picker, double radius, StrokeWidth width = {})
      : CurveTracer(CurveGround(surface, picker), radius, std::move(width)) {}

  /// Whether a place can follow the samples so far, as CurveGround::connects() says. Not so where the pen
  /// jumps over a silhouette or a gap.
  bool connects(const CurveGround::Place& place) const;
  bool connects(const SurfacePoint& point) const { return connects(ground_.place(point)); }

  /// Appends a sample at this place, and says what that changed. A sample at the place of the one before only
  /// updates time and pen.
  PenWay::Change add(const CurveGround::Place& place, double time, const Pen& pen);
  PenWay::Change add(const SurfacePoint& point, double time, const Pen& pen) {
    return add(ground_.place(point), time, pen);
  }

  const CurveGround& ground() const { return ground_; }

  const SurfaceCurve& curve() const { return curve_; }

  /// Whether the pen came back to where it began: the curve is at least four radii long, the place in its
  /// last quarter that is nearest to the first sample is at most half a radius from it, and over half a
  /// radius the curve arrives there within 60 degrees of the direction in which it began.
  bool came_back() const;

  /// The samples so far as a closed curve: the periodic spline, which goes on from the last sample to the
  /// first. What the pen drew beyond the place where it came nearest to the first sample, if that is within
  /// half a radius, is left out, and so are last samples on top of the first: nearer than half the mean
  /// distance of samples, or than half an edge. Over the closing segment the pen moves at its mean speed.
  /// Nothing where the closure leaves the curve open, the last sample does not connect with the first, or
  /// fewer than three remain.
  std::optional<SurfaceCurve> closed_curve(Closure closure) const;

  /// Points of curve() that later samples leave as they are.
  std::size_t final_points() const { return final_points_; }

 private:
  /// Where the curve, in its last quarter, is nearest to the first knot.
  struct Return {
    std::size_t point;
    double distance;
  };
  Return return_to_first() const;
  void leave_out_overshoot();
  void retrace_closed();
  void retrace_tail();
  void trace_segment(std::size_t knot);
  const PenKnot* neighbour(std::size_t knot, std::size_t steps, bool forward) const;
  double spacing(const SurfacePoint& at) const;

  PenSpline pen_spline(std::size_t knot) const;
  void append(const CurveGround::Place& place, const Vec3d& direction, double time, const Pen& pen);
  void set_widths(std::size_t from_point);
  void set_speed_around(double at_seam, double seam_time);

  CurveGround ground_;
  double radius_;
  StrokeWidth width_;
  double min_spacing_, max_spacing_;
  double first_time_ = 0;
  PenWay way_;
  std::vector<PenKnot> knots_;
  SurfaceCurve curve_;
  std::size_t final_segments_ = 0;
  std::size_t final_points_ = 0;
};

/// Between the points around t; at the ends beyond them.
PenAt pen_at(const SurfaceCurve& curve, double t);

}  // namespace burin
