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

/// In the last part of a closed curve, between its last point and the first: time goes on as before it.
PenAt pen_before_seam(const SurfaceCurve& curve, double t) {
  const CurvePoint &before = *(curve.points.end() - 2), &from = curve.points.back(), &to = curve.points[0];
  const double seconds = from.time - before.time, beyond = t - from.t;
  const double speed = seconds > 0 ? (from.t - before.t) / seconds : 0;
  const auto s = static_cast<float>(std::clamp(beyond / curve.closing_length, 0., 1.));
  return {interpolate(from.pen, to.pen, s), from.time + (speed > 0 ? beyond / speed : 0), speed,
          from.width + s * (to.width - from.width)};
}

}  // namespace

double narrowest_width(double pressure_width) { return std::max(1 - pressure_width, 0.02); }

float stroke_width(const Pen& pen, double pressure_width) {
  const double lost = pressure_width * (1 - static_cast<double>(pen.pressure));
  return static_cast<float>(std::max(1 - lost, narrowest_width(pressure_width)));
}

CurveTracer::CurveTracer(const Surface& surface, const Picker& picker, double radius, double pressure_width)
    : surface_(&surface),
      picker_(&picker),
      radius_(radius),
      pressure_width_(pressure_width),
      min_spacing_(std::max(radius / 1000, surface.scale * 1e-5)),
      max_spacing_(std::max(radius / 8, min_spacing_)) {}

bool CurveTracer::connects(const SurfacePoint& point) const {
  return knots_.empty() || connects(knots_.back().at.position, point.position);
}

bool CurveTracer::connects(const Vec3f& from, const Vec3f& to) const {
  const Vec3f chord = to - from;
  const float reach = chord.norm() / 4;
  if (reach == 0) return true;
  return std::ranges::all_of(std::array{0.25F, 0.5F, 0.75F},
                             [&](float s) { return picker_->closest(from + s * chord, reach).has_value(); });
}

void CurveTracer::add(const SurfacePoint& point, double time, const Pen& pen) {
  const double since_begin = knots_.empty() ? 0 : time - first_time_;
  if (knots_.empty()) first_time_ = time;
  const Knot knot{point, since_begin, pen, stroke_width(pen, pressure_width_)};
  if (!knots_.empty() && knots_.back().at.position == point.position) {
    knots_.back() = knot;
  } else {
    knots_.push_back(knot);
  }
  retrace_tail();
}

void CurveTracer::retrace_tail() {
  curve_.points.resize(final_points_);
  const std::size_t last = knots_.size() - 1;
  if (last == 0) append(knots_[0], Vec3d::Zero());
  for (std::size_t segment = final_segments_; segment < last; ++segment) {
    trace_segment(segment);
    if (segment + 2 <= last) {
      final_points_ = curve_.points.size();
      final_segments_ = segment + 1;
    }
  }
}

/// Traces from a knot to the next; of a closed curve, from the last knot towards the first.
void CurveTracer::trace_segment(std::size_t k) {
  const Knot &from = knots_[k], &to = *neighbour(k, 1, true);
  const Knot *before = neighbour(k, 1, false), *after = neighbour(k, 2, true);
  const auto place = [](const Knot* knot) {
    return knot ? Vec3d(knot->at.position.cast<double>()) : Vec3d(Vec3d::Zero());
  };
  const Vec3d place_before = place(before), place_after = place(after);
  const HermiteSegment spline = spline_segment(before ? &place_before : nullptr, place(&from), place(&to),
                                               after ? &place_after : nullptr);
  const double chord = (spline.to - spline.from).norm();

  if (k == 0) append(from, spline.velocity(0));
  double s = 0;
  for (;;) {
    const double speed = std::max(spline.velocity(s).norm(), chord / 4);
    const double step = spacing(curve_.points.back().at) / speed;
    s += step;
    if (s > 1 - step / 2) break;
    const auto at = picker_->closest(spline.position(s).cast<float>(), static_cast<float>(chord));
    if (at) {
      const auto share = static_cast<float>(s);
      append({*at, from.time + s * (to.time - from.time), interpolate(from.pen, to.pen, share),
              from.width + share * (to.width - from.width)},
             spline.velocity(s));
    }
  }
  if (k + 1 == knots_.size()) return;
  append(to, spline.velocity(1));
  knots_[k + 1].point = curve_.points.size() - 1;
}

/// The knot so many steps after or before; none beyond the ends of an open curve.
const CurveTracer::Knot* CurveTracer::neighbour(std::size_t knot, std::size_t steps, bool forward) const {
  const std::size_t count = knots_.size();
  if (!curve_.closed && (forward ? knot + steps >= count : knot < steps)) return nullptr;
  return &knots_[(forward ? knot + steps : knot + count - steps) % count];
}

double CurveTracer::spacing(const SurfacePoint& at) const {
  return std::clamp<double>(half_mean_edge(*surface_, at), min_spacing_, max_spacing_);
}

void CurveTracer::append(const Knot& knot, const Vec3d& direction) {
  const Vec3f& position = knot.at.position;
  const Vec3f normal = normal_at(*surface_, knot.at);
  const Vec3f tangent = unit_tangent(direction.cast<float>(), normal);
  const double t = curve_.points.empty()
                       ? 0
                       : curve_.points.back().t + arc_length(curve_.points.back(), position, tangent);
  curve_.points.push_back({knot.at, normal, tangent, t, knot.time, knot.pen, knot.width});
}

PenAt pen_at(const SurfaceCurve& curve, double t) {
  const auto& points = curve.points;
  const auto after = std::ranges::upper_bound(points, t, {}, &CurvePoint::t);
  if (points.size() == 1) return {points[0].pen, points[0].time, 0, points[0].width};
  if (curve.closed && after == points.end() && curve.closing_length > 0) return pen_before_seam(curve, t);
  const auto to = after == points.end() ? points.end() - 1 : std::max(after, points.begin() + 1);
  const auto from = to - 1;
  const double length = to->t - from->t, seconds = to->time - from->time;
  const double s = length > 0 ? std::clamp((t - from->t) / length, 0., 1.) : 1;
  return {interpolate(from->pen, to->pen, static_cast<float>(s)), from->time + s * seconds,
          seconds > 0 ? length / seconds : 0,
          from->width + static_cast<float>(s) * (to->width - from->width)};
}

}  // namespace burin
