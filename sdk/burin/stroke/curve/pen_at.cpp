// Interpolates the pen and the frame of a curve linearly between its points.
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/pen_angles.h>

#include <algorithm>

namespace burin {
namespace {

PenAt place_between(const CurvePoint& a, const CurvePoint& b, double s, double t, double time) {
  const auto share = static_cast<float>(s);
  return {.pen = pen_between(a.pen, b.pen, share),
          .time = time,
          .speed = a.speed + s * (b.speed - a.speed),
          .width = a.width + share * (b.width - a.width),
          .t = t,
          .tangent = a.tangent + share * (b.tangent - a.tangent),
          .normal = a.normal + share * (b.normal - a.normal)};
}

/// Interpolates on the closing segment of a closed curve, between its last point and the first. Time advances
/// at the rate of the segment before.
PenAt pen_before_seam(const SurfaceCurve& curve, double t) {
  const CurvePoint &before = *(curve.points.end() - 2), &from = curve.points.back(), &to = curve.points[0];
  const double seconds = from.time - before.time, beyond = t - from.t;
  const double speed = seconds > 0 ? (from.t - before.t) / seconds : 0;
  return place_between(from, to, std::clamp(beyond / curve.closing_length, 0., 1.), t,
                       from.time + (speed > 0 ? beyond / speed : 0));
}

}  // namespace

PenAt pen_at(const SurfaceCurve& curve, double t) {
  const auto& points = curve.points;
  const auto after = std::ranges::upper_bound(points, t, {}, &CurvePoint::t);
  if (curve.closed && after == points.end() && curve.closing_length > 0) return pen_before_seam(curve, t);
  const auto to = after == points.end() ? points.end() - 1 : after;
  const auto from = to == points.begin() ? to : to - 1;
  const double length = to->t - from->t;
  const double s = length > 0 ? std::clamp((t - from->t) / length, 0., 1.) : 1;
  return place_between(*from, *to, s, from->t + s * length, from->time + s * (to->time - from->time));
}

}  // namespace burin
