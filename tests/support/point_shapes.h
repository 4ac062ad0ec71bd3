#pragma once
#include <burin/surface/point_set.h>

#include "support/shapes.h"

namespace burin::test {

/// The vertices of a mesh as points; normal(position) returns their normals, of any length.
template <class Normal>
PointSet points_of(const TriangleMesh& mesh, const Normal& normal) {
  PointSet points{mesh.positions, {}};
  for (const Vec3f& position : mesh.positions) points.normals.push_back(normal(position));
  return points;
}

inline PointSet plane_points(double half_width, double spacing, std::uint32_t seed) {
  return points_of(shuffled(plane(half_width, spacing, seed), seed + 1),
                   [](const Vec3f&) { return Vec3f(0, 0, 3); });
}

/// Points of the cylinder of radius 1 about the z axis, |z| <= 1, open at the ends.
inline PointSet cylinder_points(double spacing, std::uint32_t seed) {
  return points_of(shuffled(cylinder(1, 1, spacing, 0.3, seed), seed + 1),
                   [](const Vec3f& x) { return Vec3f(x.x(), x.y(), 0); });
}

/// Points of the unit sphere.
inline PointSet sphere_points(int levels, std::uint32_t seed) {
  return points_of(shuffled(sphere(levels, 0.15, seed), seed + 1), [](const Vec3f& x) { return x; });
}

}  // namespace burin::test
