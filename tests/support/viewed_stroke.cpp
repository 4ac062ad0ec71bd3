#include "support/viewed_stroke.h"

#include <burin/surface/geometry/normals.h>

#include <algorithm>

namespace burin::test {
namespace {

double longest_side(const Surface& surface, const SurfacePoint& at) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3f side = surface.positions[at.corners[i]] - surface.positions[at.corners[(i + 1) % 3]];
    longest = std::max(longest, side.cast<double>().norm());
  }
  return longest;
}

/// Whether the curve leaves the surface: its points are usually about half an edge apart.
bool leaves_surface(const Surface& surface, const SurfaceCurve& curve) {
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const SurfacePoint &from = curve.points[i - 1].at, &to = curve.points[i].at;
    const double longest = std::max(longest_side(surface, from), longest_side(surface, to));
    if ((to.position - from.position).cast<double>().norm() > 1.5 * longest) return true;
  }
  return false;
}

}  // namespace

std::optional<SurfaceCurve> viewed_stroke(const Surface& surface, const Picker& picker,
                                          const std::vector<Vec2d>& in_radii, double radius,
                                          std::mt19937& random) {
  const auto middle = static_cast<Index>(random() % surface.vertex_count());
  const Vec3f n = surface.normals[middle], right = n.unitOrthogonal(), up = n.cross(right);
  const Vec3f above = surface.positions[middle] + static_cast<float>(3 * radius) * n;
  const CurveGround ground(surface, picker);
  CurveTracer tracer(ground, radius);
  std::optional<CurveGround::Point> before;
  std::size_t count = 0;
  for (const Vec2d& sample : in_radii) {
    const Vec2f at = (radius * sample).cast<float>();
    const auto hit = picker.pick({above + at.x() * right + at.y() * up, -n});
    if (!hit || normal_at(surface, *hit).dot(n) <= 0) break;
    const CurveGround::Point point = ground.point(*hit);
    // Without a radius no path over a fold joins two points.
    if (before && !ground.connects(*before, point, 0)) break;
    tracer.add(point, static_cast<double>(count) / 240, {});
    before = point;
    ++count;
  }
  if (2 * count < in_radii.size() || leaves_surface(surface, tracer.curve())) return std::nullopt;
  return tracer.curve();
}

}  // namespace burin::test
