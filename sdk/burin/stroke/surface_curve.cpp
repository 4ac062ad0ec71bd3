// Surface curves: samples joined by centripetal Catmull-Rom splines [Barry and Goldman 1988; Yuksel et al.
// 2011], brought onto the surface by closest points.
#include <burin/stroke/surface_curve.h>
#include <burin/surface/normals.h>
#include <burin/surface/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

float half_mean_edge(const Surface& surface, const SurfacePoint& at) {
  const auto& c = at.corners;
  const Vec3f &a = surface.positions[c[0]], &b = surface.positions[c[1]], &d = surface.positions[c[2]];
  return ((b - a).norm() + (d - b).norm() + (a - d).norm()) / 6;
}

/// One segment of the spline in Hermite form over [0, 1].
struct HermiteSegment {
  Vec3d from, to, tangent_from, tangent_to;

  Vec3d position(double s) const {
    const double s2 = s * s, s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * from + (s3 - 2 * s2 + s) * tangent_from + (3 * s2 - 2 * s3) * to +
           (s3 - s2) * tangent_to;
  }
  Vec3d velocity(double s) const {
    const double s2 = s * s;
    return 6 * (s2 - s) * (from - to) + (3 * s2 - 4 * s + 1) * tangent_from + (3 * s2 - 2 * s) * tangent_to;
  }
};

/// The tangent at b of the spline through a, b, c with centripetal knots, per unit of the knot interval.
Vec3d knot_tangent(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double before = std::sqrt((b - a).norm()), after = std::sqrt((c - b).norm());
  return (b - a) / before - (c - a) / (before + after) + (c - b) / after;
}

/// The same at a, of the parabola through the three: the spline's tangent where it begins, or, in reverse,
/// where it ends.
Vec3d end_tangent(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double near = std::sqrt((b - a).norm()), far = std::sqrt((c - b).norm());
  const Vec3d first = (b - a) / near, second = (c - b) / far;
  return first + near / (near + far) * (first - second);
}

/// The segment from b to c; a or d may be missing.
HermiteSegment spline_segment(const Vec3d* a, const Vec3d& b, const Vec3d& c, const Vec3d* d) {
  const double interval = std::sqrt((c - b).norm());
  const Vec3d chord = c - b;
  const Vec3d at_b = a   ? Vec3d(interval * knot_tangent(*a, b, c))
                     : d ? Vec3d(interval * end_tangent(b, c, *d))
                         : chord;
  const Vec3d at_c = d   ? Vec3d(interval * knot_tangent(b, c, *d))
                     : a ? Vec3d(-interval * end_tangent(c, b, *a))
                         : chord;
  return {b, c, at_b, at_c};
}

/// Of the circular arc that turns from the one tangent to the other over the chord. At a corner, the chord.
double arc_length(const CurvePoint& from, const Vec3f& to, const Vec3f& tangent) {
  const double chord = (to - from.at.position).cast<double>().norm();
  const double turn = (tangent - from.tangent).cast<double>().squaredNorm();
  constexpr double corner = 0.25;
  return turn < corner ? chord * (1 + turn / 24) : chord;
}

Pen interpolate(const Pen& a, const Pen& b, float s) {
  const auto mix = [s](float x, float y) { return x + s * (y - x); };
  return {mix(a.pressure, b.pressure), mix(a.tilt_x, b.tilt_x), mix(a.tilt_y, b.tilt_y),
          mix(a.twist, b.twist)};
}

}  // namespace

CurveTracer::CurveTracer(const Surface& surface, const Picker& picker, double radius)
    : surface_(&surface),
      picker_(&picker),
      min_spacing_(std::max(radius / 1000, surface.scale * 1e-5)),
      max_spacing_(std::max(radius / 8, min_spacing_)) {}

bool CurveTracer::connects(const SurfacePoint& point) const {
  if (knots_.empty()) return true;
  const Vec3f from = knots_.back().at.position, chord = point.position - from;
  const float reach = chord.norm() / 4;
  if (reach == 0) return true;
  return std::ranges::all_of(std::array{0.25F, 0.5F, 0.75F},
                             [&](float s) { return picker_->closest(from + s * chord, reach).has_value(); });
}

void CurveTracer::add(const SurfacePoint& point, double time, const Pen& pen) {
  const double since_begin = knots_.empty() ? 0 : time - first_time_;
  if (knots_.empty()) first_time_ = time;
  if (!knots_.empty() && knots_.back().at.position == point.position) {
    knots_.back().time = since_begin;
    knots_.back().pen = pen;
  } else {
    knots_.push_back({point, since_begin, pen});
  }
  retrace_tail();
}

void CurveTracer::retrace_tail() {
  curve_.points.resize(final_points_);
  const std::size_t last = knots_.size() - 1;
  if (last == 0) append(knots_[0].at, Vec3d::Zero(), knots_[0].time, knots_[0].pen);
  for (std::size_t segment = final_segments_; segment < last; ++segment) {
    trace_segment(segment);
    if (segment + 2 <= last) {
      final_points_ = curve_.points.size();
      final_segments_ = segment + 1;
    }
  }
}

void CurveTracer::trace_segment(std::size_t k) {
  const Knot &from = knots_[k], &to = knots_[k + 1];
  const auto place = [this](std::size_t i) { return Vec3d(knots_[i].at.position.cast<double>()); };
  const bool has_before = k > 0, has_after = k + 2 < knots_.size();
  const Vec3d before = has_before ? place(k - 1) : Vec3d::Zero();
  const Vec3d after = has_after ? place(k + 2) : Vec3d::Zero();
  const HermiteSegment spline =
      spline_segment(has_before ? &before : nullptr, place(k), place(k + 1), has_after ? &after : nullptr);
  const double chord = (spline.to - spline.from).norm();

  if (k == 0) append(from.at, spline.velocity(0), from.time, from.pen);
  double s = 0;
  for (;;) {
    const double speed = std::max(spline.velocity(s).norm(), chord / 4);
    const double step = spacing(curve_.points.back().at) / speed;
    s += step;
    if (s > 1 - step / 2) break;
    const auto at = picker_->closest(spline.position(s).cast<float>(), static_cast<float>(chord));
    if (at) {
      append(*at, spline.velocity(s), from.time + s * (to.time - from.time),
             interpolate(from.pen, to.pen, static_cast<float>(s)));
    }
  }
  append(to.at, spline.velocity(1), to.time, to.pen);
}

double CurveTracer::spacing(const SurfacePoint& at) const {
  return std::clamp<double>(half_mean_edge(*surface_, at), min_spacing_, max_spacing_);
}

void CurveTracer::append(const SurfacePoint& at, const Vec3d& direction, double time, const Pen& pen) {
  const Vec3f normal = normal_at(*surface_, at);
  const Vec3f tangent = unit_tangent(direction.cast<float>(), normal);
  const double t = curve_.points.empty()
                       ? 0
                       : curve_.points.back().t + arc_length(curve_.points.back(), at.position, tangent);
  curve_.points.push_back({at, normal, tangent, t, time, pen});
}

PenAt pen_at(const SurfaceCurve& curve, double t) {
  const auto& points = curve.points;
  const auto after = std::ranges::upper_bound(points, t, {}, &CurvePoint::t);
  if (points.size() == 1) return {points[0].pen, points[0].time, 0, points[0].width};
  const auto to = after == points.end() ? points.end() - 1 : std::max(after, points.begin() + 1);
  const auto from = to - 1;
  const double length = to->t - from->t, seconds = to->time - from->time;
  const double s = length > 0 ? std::clamp((t - from->t) / length, 0., 1.) : 1;
  return {interpolate(from->pen, to->pen, static_cast<float>(s)), from->time + s * seconds,
          seconds > 0 ? length / seconds : 0,
          from->width + static_cast<float>(s) * (to->width - from->width)};
}

}  // namespace burin
