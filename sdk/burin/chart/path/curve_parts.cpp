// Finds segments and points of a curve by arc length with a binary search, and cuts parts out of a curve in
// O(n).
#include <burin/chart/path/closed_length.h>
#include <burin/chart/path/curve_parts.h>

#include <algorithm>

namespace burin {

std::size_t segment_at(const SurfaceCurve& curve, double t) {
  const auto after = std::ranges::upper_bound(curve.points, t, {}, &CurvePoint::t) - curve.points.begin();
  const auto point = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1)) - 1;
  return std::min(point, curve.segment_count() - 1);
}

CurvePoint point_at(const SurfaceCurve& curve, double along_curve) {
  const double t = curve.closed ? wrapped_t(along_curve, curve.length()) : along_curve;
  const std::size_t segment = segment_at(curve, t);
  const CurvePoint &a = curve.points[segment], &b = curve.points[curve.next(segment)];
  const double extent = curve.segment_end(segment) - a.t;
  const float s = extent > 0 ? static_cast<float>(std::clamp((t - a.t) / extent, 0., 1.)) : 0;
  CurvePoint point = s < 0.5F ? a : b;
  point.at.position = (1 - s) * a.at.position + s * b.at.position;
  const Vec3f normal = (1 - s) * a.normal + s * b.normal;
  if (normal.squaredNorm() > 0) point.normal = normal.normalized();
  const Vec3f along = (1 - s) * a.tangent + s * b.tangent;
  const Vec3f flat = along - point.normal.dot(along) * point.normal;
  if (flat.squaredNorm() > 0) point.tangent = flat.normalized();
  point.width = (1 - s) * a.width + s * b.width;
  point.t = t;
  return point;
}

std::size_t first_ending_from(const SurfaceCurve& curve, std::size_t segment, double t) {
  while (segment > 0 && curve.segment_end(segment - 1) >= t) --segment;
  return segment;
}

bool has_uniform_width(const SurfaceCurve& curve) {
  return std::ranges::all_of(curve.points, [](const CurvePoint& point) { return point.width == 1; });
}

SurfaceCurve part_of(const SurfaceCurve& curve, double begin, double end) {
  SurfaceCurve part;
  const double length = curve.length();
  const auto add = [&](CurvePoint point, double t) {
    point.t = t - begin;
    part.points.push_back(std::move(point));
  };
  add(point_at(curve, begin), begin);
  for (const double around : {0., length}) {
    if (around > 0 && !curve.closed) break;
    for (const CurvePoint& point : curve.points)
      if (point.t + around > begin && point.t + around < end) add(point, point.t + around);
  }
  add(point_at(curve, end), end);
  return part;
}

std::size_t update_part(SurfaceCurve& part, const SurfaceCurve& curve, double begin, double end,
                        double unchanged_t) {
  // The last point was interpolated at the end of the part.
  const double kept_before = std::min(unchanged_t, end) - begin;
  const auto is_gone = [&](const CurvePoint& point) { return point.t >= kept_before; };
  part.points.pop_back();
  while (!part.points.empty() && is_gone(part.points.back())) part.points.pop_back();
  const std::size_t kept = part.points.size();
  const auto add = [&](CurvePoint point, double t) {
    point.t = t - begin;
    part.points.push_back(std::move(point));
  };
  if (kept == 0) add(point_at(curve, begin), begin);
  const auto in_part = [&](const CurvePoint& point) { return point.t - begin; };
  for (auto next = std::ranges::upper_bound(curve.points, part.points.back().t, {}, in_part);
       next != curve.points.end() && next->t < end; ++next)
    add(*next, next->t);
  add(point_at(curve, end), end);
  return kept;
}

}  // namespace burin
