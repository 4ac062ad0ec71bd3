#pragma once
#include <burin/stroke/curve_ground.h>
#include <burin/stroke/dynamics.h>
#include <burin/stroke/pen_spline.h>
#include <burin/stroke/pen_way.h>
#include <burin/stroke/recording.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Seconds; see CurvePoint::speed.
inline constexpr double speed_fading_time = 0.04;

/// A point of a stroke on a surface with its Darboux frame: e1 = tangent, n = normal, e2 = n x e1.
struct CurvePoint {
  SurfacePoint at;
  Vec3f normal;     ///< of the surface, interpolated, unit
  Vec3f tangent;    ///< unit, at right angles to the normal, in the direction of travel
  double t = 0;     ///< arc length from the first point, object units
  double time = 0;  ///< seconds since the first sample
  Pen pen;
  /// Object units a second: the mean over the time so far that fades as exp(-age / speed_fading_time). Before
  /// the first sample the pen rested; that of a closed curve came around. So it hardly depends on the rate
  /// of the samples, and on an open curve not on later ones.
  double speed = 0;
  float width = 1;  ///< of the stroke here, a share of its radius, in (0, 1]; linear between points
};

/// A stroke on a surface: a polyline whose points lie on it, about half an edge apart. A closed one goes on
/// from its last point to the first.
struct SurfaceCurve {
  std::vector<CurvePoint> points;
  bool closed = false;
  double closing_length = 0;  ///< arc length from the last point to the first of a closed curve

  double length() const { return points.empty() ? 0 : points.back().t + closing_length; }

  /// Segments go from a point to the next. A curve of one point has one, without extent.
  std::size_t segment_count() const {
    return closed ? points.size() : std::max<std::size_t>(points.size(), 2) - 1;
  }
  /// The point at which the segment from this point ends.
  std::size_t next(std::size_t point) const {
    return point + 1 < points.size() ? point + 1 : closed ? 0 : points.size() - 1;
  }
  /// Arc length at the end of a segment.
  double segment_end(std::size_t segment) const {
    return segment + 1 < points.size() ? points[segment + 1].t : length();
  }
};

/// Whether a stroke goes around.
enum class Closure {
  open,
  closed,
  automatic,  ///< closed where the pen came back, as CurveTracer::came_back() says
};

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
