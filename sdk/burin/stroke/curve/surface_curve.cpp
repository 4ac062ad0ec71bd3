// Traces the curve of a stroke: a centripetal Catmull-Rom spline through the samples [Barry and Goldman 1988;
// Yuksel, Schaefer and Keyser 2011], sampled half an edge apart and projected onto the ground by closest
// points. A new sample traces only the segments that are not final, so its cost does not depend on the
// length of the stroke.
#include <burin/math/elementary.h>
#include <burin/stroke/curve/curve_spline.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// CurvePoint::speed after a step of this length and duration from a point.
double faded_speed(const CurvePoint& from, double length, double seconds) {
  const double faded = -math::expm1(-seconds / speed_fading_time);
  const double weight = seconds > 0 ? faded / seconds : 1 / speed_fading_time;
  return from.speed * (1 - faded) + length * weight;
}

}  // namespace

CurveTracer::CurveTracer(const CurveGround& ground, double radius, StrokeWidth width)
    : ground_(ground),
      radius_(radius),
      width_(std::move(width)),
      min_spacing_(std::max(radius / 1000, ground.scale() * 1e-5)),
      max_spacing_(std::max(radius / 8, min_spacing_)),
      path_(radius, min_spacing_ / 2) {}

bool CurveTracer::connects(const CurveGround::Point& place) const {
  return knots_.empty() || ground_.connects(knots_.back().ground_point, place, radius_);
}

PenPath::Change CurveTracer::add(const CurveGround::Point& place, double time, const Pen& pen) {
  if (knots_.empty()) first_time_ = time;
  const PenPath::Change change =
      path_.add(knots_, {.ground_point = place, .time = time - first_time_, .pen = pen});
  if (change != PenPath::Change::none) retrace_tail();
  return change;
}

void CurveTracer::retrace_tail() {
  curve_.points.resize(final_points_);
  const std::size_t last = knots_.size() - 1;
  const std::size_t kept = final_points_;
  if (last == 0) append(knots_[0].ground_point, Vec3d::Zero(), knots_[0].time, knots_[0].pen);
  for (std::size_t segment = final_segments_; segment < last; ++segment) {
    trace_segment(segment);
    if (segment + 2 < path_.taken()) {
      final_points_ = curve_.points.size();
      final_segments_ = segment + 1;
    }
  }
  set_widths(curve_, width_, kept);
}

/// Appends the points from knot k to the next; on a closed curve the first knot follows the last.
void CurveTracer::trace_segment(std::size_t k) {
  const PenKnot &from = knots_[k], &to = *neighbour(k, 1, true);
  const PenKnot *before = neighbour(k, 1, false), *after = neighbour(k, 2, true);
  const auto place = [](const PenKnot* knot) {
    return knot ? Vec3d(knot->position().cast<double>()) : Vec3d(Vec3d::Zero());
  };
  const Vec3d place_before = place(before), place_after = place(after);
  const HermiteSegment spline = spline_segment(before ? &place_before : nullptr, place(&from), place(&to),
                                               after ? &place_after : nullptr, KnotSpacing::centripetal);
  const PenSpline pens = pen_spline(k);
  const double chord = (spline.to - spline.from).norm();

  if (k == 0) append(from.ground_point, spline.velocity(0), from.time, from.pen);
  double s = 0;
  for (;;) {
    const double speed = std::max(spline.velocity(s).norm(), chord / 4);
    const double step = spacing(curve_.points.back().at) / speed;
    s += step;
    if (s > 1 - step / 2) break;
    const auto at =
        ground_.closest(spline.position(s).cast<float>(), static_cast<float>(chord), curve_.points.back().at);
    if (at) append(*at, spline.velocity(s), pens.time(s), pens.pen(s));
  }
  if (k + 1 == knots_.size()) return;
  append(to.ground_point, spline.velocity(1), to.time, to.pen);
  knots_[k + 1].point = curve_.points.size() - 1;
}

/// The knot so many steps after or before; null beyond the ends of an open curve.
const PenKnot* CurveTracer::neighbour(std::size_t knot, std::size_t steps, bool forward) const {
  const std::size_t count = knots_.size();
  if (!curve_.closed && (forward ? knot + steps >= count : knot < steps)) return nullptr;
  return &knots_[(forward ? knot + steps : knot + count - steps) % count];
}

double CurveTracer::spacing(const SurfacePoint& at) const {
  return std::clamp<double>(ground_.point_spacing(at), min_spacing_, max_spacing_);
}

/// The spline of time and pen from knot k to the next. On a closed curve the pen continues across the seam,
/// the time does not.
PenSpline CurveTracer::pen_spline(std::size_t k) const {
  const PenKnot *before = neighbour(k, 1, false), *after = neighbour(k, 2, true);
  const auto interval = [](const PenKnot* a, const PenKnot* b) {
    return a && b ? std::sqrt((b->position() - a->position()).cast<double>().norm()) : 0;
  };
  const PenKnot &from = knots_[k], &to = *neighbour(k, 1, true);
  const MonotoneCubic::Intervals intervals{interval(before, &from), interval(&from, &to),
                                           interval(&to, after)};
  const MonotoneCubic::Intervals in_order{k > 0 ? intervals.before : 0, intervals.within,
                                          k + 2 < knots_.size() ? intervals.after : 0};
  const PenKnot &first = before ? *before : from, &last = after ? *after : to;
  return {{in_order, first.time, from.time, to.time, last.time},
          {intervals, first.pen, from.pen, to.pen, last.pen}};
}

void CurveTracer::append(const CurveGround::Point& place, const Vec3d& direction, double time,
                         const Pen& pen) {
  const SurfacePoint& at = place.at;
  const Vec3f tangent = unit_tangent(direction.cast<float>(), place.normal);
  CurvePoint point{.at = at, .normal = place.normal, .tangent = tangent, .time = time, .pen = pen};
  if (!curve_.points.empty()) {
    const CurvePoint& before = curve_.points.back();
    const double length = arc_length(before, at.position, point.tangent);
    point.t = before.t + length;
    point.speed = faded_speed(before, length, time - before.time);
  }
  curve_.points.push_back(point);
}

}  // namespace burin
