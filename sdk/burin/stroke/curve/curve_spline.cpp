// Catmull-Rom splines [Barry and Goldman 1988; Yuksel, Schaefer and Keyser 2011], segment by segment.
#include <burin/stroke/curve/curve_spline.h>

#include <cmath>

namespace burin {
namespace {

double knot_interval(const Vec3d& a, const Vec3d& b, KnotSpacing spacing) {
  const double chord = (b - a).norm();
  return spacing == KnotSpacing::centripetal ? std::sqrt(chord) : chord;
}

/// The tangent at b of the spline through a, b, c, per unit of the knot interval.
Vec3d knot_tangent(const Vec3d& a, const Vec3d& b, const Vec3d& c, KnotSpacing spacing) {
  const double before = knot_interval(a, b, spacing), after = knot_interval(b, c, spacing);
  return (b - a) / before - (c - a) / (before + after) + (c - b) / after;
}

/// The tangent at a, per unit of the knot interval, of the parabola through a, b, c: the spline's tangent at
/// its start or, with the points in reverse order, the reversed tangent at its end.
Vec3d end_tangent(const Vec3d& a, const Vec3d& b, const Vec3d& c, KnotSpacing spacing) {
  const double near = knot_interval(a, b, spacing), far = knot_interval(b, c, spacing);
  const Vec3d first = (b - a) / near, second = (c - b) / far;
  return first + near / (near + far) * (first - second);
}

PenAt pen_of(const CurvePoint& point) {
  return {.pen = point.pen,
          .time = point.time,
          .speed = point.speed,
          .width = point.width,
          .t = point.t,
          .tangent = point.tangent,
          .normal = point.normal};
}

}  // namespace

Vec3d HermiteSegment::position(double s) const {
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * from + (s3 - 2 * s2 + s) * tangent_from + (3 * s2 - 2 * s3) * to +
         (s3 - s2) * tangent_to;
}

Vec3d HermiteSegment::velocity(double s) const {
  const double s2 = s * s;
  return 6 * (s2 - s) * (from - to) + (3 * s2 - 4 * s + 1) * tangent_from + (3 * s2 - 2 * s) * tangent_to;
}

HermiteSegment spline_segment(const Vec3d* a, const Vec3d& b, const Vec3d& c, const Vec3d* d,
                              KnotSpacing spacing) {
  const double interval = knot_interval(b, c, spacing);
  const Vec3d chord = c - b;
  const Vec3d at_b = a   ? Vec3d(interval * knot_tangent(*a, b, c, spacing))
                     : d ? Vec3d(interval * end_tangent(b, c, *d, spacing))
                         : chord;
  const Vec3d at_c = d   ? Vec3d(interval * knot_tangent(b, c, *d, spacing))
                     : a ? Vec3d(-interval * end_tangent(c, b, *a, spacing))
                         : chord;
  return {b, c, at_b, at_c};
}

double arc_length(const CurvePoint& from, const Vec3f& to, const Vec3f& tangent) {
  const double chord = (to - from.at.position).cast<double>().norm();
  const double turn = (tangent - from.tangent).cast<double>().squaredNorm();
  constexpr double corner = 0.25;
  return turn < corner ? chord * (1 + turn / 24) : chord;
}

void set_widths(SurfaceCurve& curve, const StrokeWidth& width, std::size_t from_point) {
  if (!width.varies()) return;
  const double loop = curve.closed ? curve.length() : 0;
  for (std::size_t i = from_point; i < curve.points.size(); ++i) {
    CurvePoint& point = curve.points[i];
    point.width = width.at(pen_of(point), loop);
  }
}

}  // namespace burin
