// Closed strokes: detects that the pen came back to its start, and traces the periodic centripetal Catmull-
// Rom spline through the samples. O(points) per closed curve, since the seam changes all speeds.
#include <burin/math/elementary.h>
#include <burin/stroke/curve/curve_spline.h>
#include <burin/stroke/curve/surface_curve.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

CurveTracer::Return CurveTracer::return_to_first() const {
  const auto& points = curve_.points;
  Return nearest{points.size() - 1, std::numeric_limits<double>::infinity()};
  for (std::size_t i = points.size(); i-- > 0 && points[i].t >= 0.75 * curve_.length();) {
    const double distance = (points[i].at.position - points[0].at.position).cast<double>().norm();
    if (distance < nearest.distance) nearest = {i, distance};
  }
  return nearest;
}

bool CurveTracer::came_back() const {
  const auto& points = curve_.points;
  if (curve_.length() < 4 * radius_) return false;
  const auto [point, distance] = return_to_first();
  if (distance > radius_ / 2) return false;
  const auto later = std::ranges::lower_bound(points, radius_ / 2, {}, &CurvePoint::t);
  const auto earlier = std::ranges::lower_bound(points, points[point].t - radius_ / 2, {}, &CurvePoint::t);
  const Vec3f away = later->at.position - points[0].at.position;
  const Vec3f back = points[point].at.position - earlier->at.position;
  constexpr float cosine = 0.5F;
  return away.dot(back) >= cosine * away.norm() * back.norm();
}

std::optional<SurfaceCurve> CurveTracer::closed_curve(Closure closure) const {
  if (closure == Closure::open || knots_.empty() || (closure == Closure::automatic && !came_back()))
    return {};
  CurveTracer loop = *this;
  loop.remove_overshoot();
  if (loop.knots_.size() < 3 || !loop.connects(knots_[0].ground_point)) return {};
  loop.retrace_closed();
  return std::move(loop.curve_);
}

void CurveTracer::remove_overshoot() {
  const auto [point, distance] = return_to_first();
  if (distance <= radius_ / 2)
    std::erase_if(knots_, [last = point](const PenKnot& knot) { return knot.point > last; });
  const double mean = curve_.points[knots_.back().point].t / static_cast<double>(knots_.size());
  const double on_top = std::max(mean / 2, spacing(knots_[0].ground_point.at));
  const auto from_first = [&](const PenKnot& knot) {
    return (knot.position() - knots_[0].position()).cast<double>().norm();
  };
  while (knots_.size() > 1 && from_first(knots_.back()) < on_top) knots_.pop_back();
}

void CurveTracer::retrace_closed() {
  const PenKnot& last = knots_.back();
  const double drawn = curve_.points[last.point].t;
  const double gap = (knots_[0].position() - last.position()).cast<double>().norm();
  const double seam_time = drawn > 0 ? last.time * (1 + gap / drawn) : last.time;
  curve_ = {.points = {}, .closed = true};
  for (std::size_t segment = 0; segment < knots_.size(); ++segment) {
    if (segment + 1 == knots_.size()) knots_[0].time = seam_time;
    trace_segment(segment);
  }
  const double end = curve_.points.back().t;
  append(knots_[0].ground_point, curve_.points[0].tangent.cast<double>(), seam_time, knots_[0].pen);
  curve_.closing_length = curve_.points.back().t - end;
  const double speed = curve_.points.back().speed;
  curve_.points.pop_back();
  if (seam_time > 0) set_speed_around(speed, seam_time);
  set_widths(curve_, width_, 0);
}

/// Adds to the speed of all points what the pen's motion before the seam contributes: a closed curve
/// continues from its end, whereas append() assumes that the pen rested before the first sample.
void CurveTracer::set_speed_around(double at_seam, double seam_time) {
  const double at_first = at_seam / -math::expm1(-seam_time / speed_fading_time);
  for (CurvePoint& point : curve_.points)
    point.speed += at_first * math::exp(-point.time / speed_fading_time);
}

}  // namespace burin
