// Moves the points of a curve over the surface in short straight steps, each projected onto the ground and
// its direction onto the tangent plane, which follows the geodesic to second order in the step. Then traces
// the chordal Catmull-Rom spline through the moved points. Costs O(steps) per moved point.
#include <burin/stroke/curve/curve_spline.h>
#include <burin/stroke/curve/moved_curve.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The longest step, in radii.
constexpr double longest_step = 0.25;

/// The way that may be missing at the end of a move, in radii.
constexpr double exact_enough = 1e-5;

PenAt drawn_pen(const CurvePoint& drawn) {
  return {.pen = drawn.pen, .time = drawn.time, .speed = drawn.speed, .t = drawn.t};
}

}  // namespace

void MovedCurve::follow(const SurfaceCurve& drawn, std::size_t final_points, const Offsets& offsets) {
  if (drawn.closed) {
    curve_ = {};
    knots_.clear();
    settled_ = final_segments_ = final_points_ = 0;
  }
  while (!knots_.empty() && knots_.back().drawn >= settled_) knots_.pop_back();
  const std::size_t first = settled_;
  if (!drawn.closed && final_points > 0) {
    const double known = drawn.points[final_points - 1].t;
    while (settled_ < final_points && drawn.points[settled_].t + reach_.ahead <= known) ++settled_;
  }
  move_points(drawn, first, offsets);
  curve_.closed = drawn.closed && knots_.size() >= 3;
  trace(drawn);
}

/// Adds those of the moved points from `first` on that are far enough from each other to the knots.
void MovedCurve::move_points(const SurfaceCurve& drawn, std::size_t first, const Offsets& offsets) {
  const std::vector<CurveOffset> found = offsets(drawn, first);
  const auto far_from = [&](const Knot& before, const CurveGround::Point& place, double share) {
    return (place.at.position.cast<double>() - before.position()).norm() > share * tracer_->spacing(place.at);
  };
  constexpr double least = 0.25, least_at_end = 1e-3;
  for (std::size_t i = first; i < drawn.points.size(); ++i) {
    const CurveGround::Point place = moved(drawn.points[i], found[i - first]);
    const bool last = i + 1 == drawn.points.size();
    if (knots_.empty() || far_from(knots_.back(), place, last ? least_at_end : least))
      knots_.push_back({place, i});
  }
  while (drawn.closed && knots_.size() > 1 && !far_from(knots_.back(), knots_.front().ground_point, least))
    knots_.pop_back();
}

CurveGround::Point MovedCurve::moved(const CurvePoint& point, const CurveOffset& offset) const {
  CurveGround::Point place{point.at, point.normal, {}};
  const Vec3f across = point.normal.cross(point.tangent);
  const Vec3f way = offset.along * point.tangent + offset.across * across;
  Vec3f direction = unit_tangent(way, point.normal);
  double left = static_cast<double>(way.norm());
  double longest = longest_step * radius_;
  while (left > exact_enough * radius_) {
    const double length = std::min(left, longest);
    if (step(place, direction, length, left)) continue;
    // A shorter step may lead to the edge at which the surface turns or ends.
    longest = length / 2;
    if (longest < longest_step * radius_ / 64) break;
  }
  return place;
}

/// Goes on by a step of this length, and takes the way made from the one that is left. Returns false, and
/// stays, where the ground leads elsewhere.
bool MovedCurve::step(CurveGround::Point& place, Vec3f& direction, double length, double& left) const {
  const auto reach = static_cast<float>(length);
  const auto next = tracer_->ground().closest(place.at.position + reach * direction, reach, place.at);
  if (!next) return false;
  const Vec3f chord = next->at.position - place.at.position;
  const Vec3f side = place.normal.cross(direction);
  constexpr float least = 0.25F, most_aside = 0.125F, folded = -0.5F;
  if (!(chord.dot(direction) > least * reach && std::abs(chord.dot(side)) < most_aside * reach)) return false;
  if (next->normal.dot(place.normal) < folded || !tracer_->ground().is_covered(*next, radius_)) return false;
  const Vec3f turned = unit_tangent(direction, next->normal);
  const double turn = (turned - direction).cast<double>().squaredNorm();
  left -= chord.cast<double>().norm() * (1 + turn / 24);
  place = *next;
  direction = turned;
  return true;
}

void MovedCurve::trace(const SurfaceCurve& drawn) {
  curve_.points.resize(final_points_);
  const std::size_t kept = final_points_;
  const auto settled_knots =
      static_cast<std::size_t>(std::ranges::lower_bound(knots_, settled_, {}, &Knot::drawn) - knots_.begin());
  if (knots_.size() == 1) {
    const CurvePoint& point = drawn.points[knots_[0].drawn];
    append(knots_[0].ground_point, point.tangent.cast<double>(), drawn_pen(point));
  }
  const std::size_t segments = knots_.size() - (curve_.closed ? 0 : 1);
  for (std::size_t segment = final_segments_; segment < segments; ++segment) {
    trace_segment(drawn, segment);
    if (segment + 2 < settled_knots) {
      final_points_ = curve_.points.size();
      final_segments_ = segment + 1;
    }
  }
  if (curve_.closed) close();
  set_widths(curve_, width_, kept);
}

/// Appends the points from knot k to the next; on a closed curve the first knot follows the last.
void MovedCurve::trace_segment(const SurfaceCurve& drawn, std::size_t k) {
  const Knot &from = knots_[k], &to = *neighbour(k, 1, true);
  const Knot *before = neighbour(k, 1, false), *after = neighbour(k, 2, true);
  const auto place = [](const Knot* knot) { return knot ? knot->position() : Vec3d(Vec3d::Zero()); };
  const Vec3d place_before = place(before), place_after = place(after);
  const HermiteSegment spline =
      spline_segment(before ? &place_before : nullptr, from.position(), to.position(),
                     after ? &place_after : nullptr, KnotSpacing::chordal);
  const double t_from = drawn.points[from.drawn].t;
  const double t_to = &to == &knots_[0] ? drawn.length() : drawn.points[to.drawn].t;
  if (k == 0) append(from.ground_point, spline.velocity(0), drawn_pen(drawn.points[from.drawn]));
  const double chord = (to.position() - from.position()).norm();
  const double pieces = std::max(1.0, std::round(chord / tracer_->spacing(from.ground_point.at)));
  for (double piece = 1; piece < pieces; ++piece) {
    const double s = piece / pieces;
    const auto at = tracer_->ground().closest(spline.position(s).cast<float>(), static_cast<float>(chord),
                                              curve_.points.back().at);
    if (at) append(*at, spline.velocity(s), pen_at(drawn, t_from + s * (t_to - t_from)));
  }
  append(to.ground_point, spline.velocity(1), drawn_pen(drawn.points[to.drawn]));
}

/// The knot so many steps after or before; null beyond the ends of an open curve.
const MovedCurve::Knot* MovedCurve::neighbour(std::size_t knot, std::size_t steps, bool forward) const {
  const std::size_t count = knots_.size();
  if (!curve_.closed && (forward ? knot + steps >= count : knot < steps)) return nullptr;
  return &knots_[(forward ? knot + steps : knot + count - steps) % count];
}

void MovedCurve::append(const CurveGround::Point& place, const Vec3d& direction, const PenAt& pen) {
  const Vec3f tangent = unit_tangent(direction.cast<float>(), place.normal);
  CurvePoint point{.at = place.at,
                   .normal = place.normal,
                   .tangent = tangent,
                   .time = pen.time,
                   .pen = pen.pen,
                   .speed = pen.speed};
  if (!curve_.points.empty()) {
    const CurvePoint& before = curve_.points.back();
    point.t = before.t + arc_length(before, place.at.position, tangent);
  }
  curve_.points.push_back(point);
}

/// The last point of the last segment is the first of the curve again.
void MovedCurve::close() {
  const double length = curve_.points.back().t;
  curve_.points.pop_back();
  curve_.closing_length = length - curve_.points.back().t;
}

}  // namespace burin
