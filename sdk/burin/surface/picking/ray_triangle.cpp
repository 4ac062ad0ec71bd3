// Intersects rays with triangles in doubles and without gaps between neighbours [Woop, Benthin, Wald 2013].
// The ray is sheared to the z axis once, so that a triangle costs three signed areas.
#include <burin/surface/picking/ray_triangle.h>

#include <algorithm>
#include <cmath>

namespace burin {

TriangleRay::TriangleRay(const Ray& ray) : origin_(ray.origin.cast<double>()) {
  const Vec3d direction = ray.direction.cast<double>();
  direction.cwiseAbs().maxCoeff(&z_);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  shear_ = {direction[x_] / direction[z_], direction[y_] / direction[z_], 1 / direction[z_]};
}

Vec3d TriangleRay::sheared(const Vec3f& corner) const {
  const Vec3d from_origin = corner.cast<double>() - origin_;
  const double z = from_origin[z_];
  return {from_origin[x_] - shear_.x() * z, from_origin[y_] - shear_.y() * z, shear_.z() * z};
}

std::optional<TriangleHit> TriangleRay::meet(const Surface& surface, Index triangle) const {
  const Triangle& corners = surface.triangles[triangle];
  const Vec3d a = sheared(surface.positions[corners[0]]);
  const Vec3d b = sheared(surface.positions[corners[1]]);
  const Vec3d c = sheared(surface.positions[corners[2]]);
  // These are twice the signed areas of the triangles between the ray and each edge. Two triangles compute
  // the area at their common edge to the same bits except the sign, so the ray cannot pass between them.
  const double at_a = c.x() * b.y() - c.y() * b.x();
  const double at_b = a.x() * c.y() - a.y() * c.x();
  const double at_c = b.x() * a.y() - b.y() * a.x();
  if (std::min({at_a, at_b, at_c}) < 0 && std::max({at_a, at_b, at_c}) > 0) return std::nullopt;
  const double whole = at_a + at_b + at_c;
  if (whole == 0) return std::nullopt;
  const double distance = (at_a * a.z() + at_b * b.z() + at_c * c.z()) / whole;
  if (!(distance >= 0)) return std::nullopt;
  return TriangleHit{at_b / whole, at_c / whole, distance};
}

}  // namespace burin
