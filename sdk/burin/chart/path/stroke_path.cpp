// Samples the stroke at equal distances, so that position and curvature at any t cost O(1). After a change
// only the samples from the last unchanged point of the curve on are computed again.
#include <burin/chart/path/curve_parts.h>
#include <burin/chart/path/stroke_path.h>

namespace burin {
namespace {

constexpr double points_per_radius = 64, doubt_per_radius = 0.003;

}  // namespace

void StrokePath::update(const SurfaceCurve& curve, const GeodesicCurvature& curvature, double radius,
                        double finest, std::size_t unchanged, const Extensions& extensions) {
  length_ = curve.length();
  closed_ = curve.closed;
  round_begin_ = !closed_ && extensions.begin == 0;
  round_end_ = !closed_ && extensions.end == 0;
  spacing_ = std::max(radius / points_per_radius, finest);
  points_per_unit_ = 1 / spacing_;
  doubt_ = doubt_per_radius * radius;
  // Points before the last unchanged point of the curve stay, except the one that was extrapolated past the
  // end.
  const auto t = [this](std::size_t point) { return static_cast<double>(point) * spacing_; };
  if (!points_.empty()) points_.pop_back();
  while (!points_.empty() && (unchanged == 0 || t(points_.size() - 1) >= curve.points[unchanged - 1].t))
    points_.pop_back();
  const auto at = [&](double way) -> Point {
    const std::size_t from = segment_at(curve, way), to = curve.next(from);
    const double begin = curve.points[from].t, extent = curve.segment_end(from) - begin;
    const float s = extent > 0 ? static_cast<float>(std::clamp((way - begin) / extent, 0., 1.)) : 0;
    const Vec3f &a = curve.points[from].at.position, &b = curve.points[to].at.position;
    return {a + s * (b - a), curvature[from] + s * (curvature[to] - curvature[from])};
  };
  const auto last = static_cast<std::size_t>(length_ * points_per_unit_);
  while (points_.size() <= last) points_.push_back(at(t(points_.size())));
  // The end lies between the last point and one more, which is extrapolated so that interpolation gives the
  // end.
  const Point &before = points_.back(), end = at(length_);
  const double share = length_ * points_per_unit_ - static_cast<double>(last);
  const auto on = share > 1e-6 ? static_cast<float>(1 / share) : 0;
  points_.push_back({before.position + on * (end.position - before.position), end.curvature});
}

}  // namespace burin
