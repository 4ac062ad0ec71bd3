#pragma once
#include <burin/stroke/curve.h>
#include <burin/stroke/curve/curve_ground.h>
#include <burin/stroke/curve/pen_path.h>
#include <burin/stroke/curve/pen_spline.h>
#include <burin/stroke/dynamics.h>
#include <burin/stroke/recording.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Turns the samples of one stroke into its curve on the surface as they arrive. Between two samples the
/// curve follows the centripetal Catmull-Rom spline of the samples, projected onto the ground by closest
/// points; time and pen follow monotone cubics, which stay between the samples' values. PenPath leaves out
/// the tremor of a resting pen. The curve depends only on the ground, the samples so far and the radius. The
/// part before the last final knot but one is final; the next add() replaces the rest, and costs what it
/// replaces. Samples are points of the ground or of the surface. One thread.
class CurveTracer {
 public:
  /// `radius`: radius of the stroke, object units. Points are half an edge apart, but at least radius / 1000
  /// and 1e-5 of the surface's scale, and at most radius / 8 unless that is less.
  CurveTracer(const CurveGround& ground, double radius, StrokeWidth width = {});
  CurveTracer(const Surface& surface, const Picker& picker, double radius, StrokeWidth width = {})
      : CurveTracer(CurveGround(surface, picker), radius, std::move(width)) {}

  /// Whether CurveGround::connects() the last knot with a point. False where the pen jumps across a
  /// silhouette or a gap.
  bool connects(const CurveGround::Point& place) const;
  bool connects(const SurfacePoint& point) const { return connects(ground_.point(point)); }

  /// Appends a sample at this point, and returns what changed. A sample at the position of the one before
  /// only updates time and pen.
  PenPath::Change add(const CurveGround::Point& place, double time, const Pen& pen);
  PenPath::Change add(const SurfacePoint& point, double time, const Pen& pen) {
    return add(ground_.point(point), time, pen);
  }

  const CurveGround& ground() const { return ground_; }

  /// The distance of the curve's points here, object units.
  double spacing(const SurfacePoint& at) const;

  const SurfaceCurve& curve() const { return curve_; }

  /// Whether the pen came back to its start. Three conditions hold: the curve is at least four radii long;
  /// the point of its last quarter that is nearest to the first sample is at most half a radius away from it;
  /// the direction of the curve over the last half radius before that point is within 60 degrees of its
  /// direction over the first half radius.
  bool came_back() const;

  /// The curve of the samples so far as a periodic spline, which continues from the last sample to the first.
  /// If the curve comes within half a radius of the first sample, samples after the nearest point are left
  /// out. So are last samples that nearly coincide with the first: nearer than half the mean distance of
  /// samples or than half an edge. On the closing segment the pen moves at its mean speed. Returns nothing if
  /// `closure` does not ask for a closed curve, the last sample does not connect with the first, or fewer
  /// than three samples remain.
  std::optional<SurfaceCurve> closed_curve(Closure closure) const;

  /// The number of points of curve() that later samples do not change.
  std::size_t final_points() const { return final_points_; }

 private:
  /// The point in the last quarter of the curve that is nearest to the first knot.
  struct Return {
    std::size_t point;
    double distance;
  };
  Return return_to_first() const;
  void remove_overshoot();
  void retrace_closed();
  void retrace_tail();
  void trace_segment(std::size_t knot);
  const PenKnot* neighbour(std::size_t knot, std::size_t steps, bool forward) const;
  PenSpline pen_spline(std::size_t knot) const;
  void append(const CurveGround::Point& place, const Vec3d& direction, double time, const Pen& pen);
  void set_speed_around(double at_seam, double seam_time);

  CurveGround ground_;
  double radius_;
  StrokeWidth width_;
  double min_spacing_, max_spacing_;
  double first_time_ = 0;
  PenPath path_;
  std::vector<PenKnot> knots_;
  SurfaceCurve curve_;
  std::size_t final_segments_ = 0;
  std::size_t final_points_ = 0;
};

/// Interpolates pen and curve at arc length t, in O(log points). Beyond the ends they are those of the end.
PenAt pen_at(const SurfaceCurve& curve, double t);

}  // namespace burin
