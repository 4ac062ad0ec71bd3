#include "support/gentle_stroke.h"

#include <burin/surface/geometry/normals.h>

#include <cmath>
#include <numbers>

namespace burin::test {
namespace {

double uniform_in_unit(std::mt19937& random) { return static_cast<double>(random()) / 4294967295.; }

/// The point where a random ray from outside meets the surface, which is never inside a shell.
std::optional<SurfacePoint> random_outer_place(const Surface& surface, const Picker& picker,
                                               std::mt19937& random) {
  Eigen::AlignedBox3f box;
  for (const Vec3f& position : surface.positions) box.extend(position);
  const auto in_box = [&] {
    const auto x = static_cast<float>(uniform_in_unit(random)),
               y = static_cast<float>(uniform_in_unit(random));
    const auto z = static_cast<float>(uniform_in_unit(random));
    return Vec3f(box.min() + Vec3f(x, y, z).cwiseProduct(box.sizes()));
  };
  const Vec3f target = in_box(), direction = (box.center() - in_box()).normalized();
  return picker.pick({target - 2 * static_cast<float>(surface.scale) * direction, direction});
}

/// Rotates a direction to the left in the tangent plane with the normal n; radians.
Vec3f turned(const Vec3f& direction, const Vec3f& n, double angle) {
  const Vec3f flat = (direction - n.dot(direction) * n).normalized();
  return static_cast<float>(std::cos(angle)) * flat + static_cast<float>(std::sin(angle)) * n.cross(flat);
}

}  // namespace

double mean_edge(const Surface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3f &p = surface.positions[a], &q = surface.positions[b], &r = surface.positions[c];
    sum += static_cast<double>((p - q).norm() + (q - r).norm() + (r - p).norm());
  }
  return sum / (3 * static_cast<double>(surface.triangles.size()));
}

SurfaceCurve gentle_stroke(const Surface& surface, const Picker& picker, double radius, double length,
                           std::mt19937& random) {
  const double step = radius / 8, sharpest = 1 / (2 * radius),
               phase = 2 * std::numbers::pi * uniform_in_unit(random);
  CurveTracer tracer(surface, picker, radius);
  const auto begin = random_outer_place(surface, picker, random);
  if (!begin) return {};
  Vec3f place = begin->position, direction = Vec3f::Zero();
  for (double s = 0; s < length; s += step) {
    const auto at = picker.closest(place, static_cast<float>(radius));
    if (!at || (s > 0 && !tracer.connects(*at))) break;
    tracer.add(*at, s, {});
    const Vec3f n = normal_at(surface, *at);
    if (s == 0) direction = turned(n.unitOrthogonal(), n, 2 * std::numbers::pi * uniform_in_unit(random));
    direction = turned(direction, n, step * sharpest * std::cos(phase + s / (2 * radius)));
    place = at->position + static_cast<float>(step) * direction;
  }
  return tracer.curve();
}

}  // namespace burin::test
