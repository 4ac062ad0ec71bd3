#pragma once
#include <burin/base/vector.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <optional>

namespace burin {

/// The point u * corner 1 + v * corner 2 + (1 - u - v) * corner 0 where a ray meets a triangle.
struct TriangleHit {
  double u, v;
  double distance;  ///< >= 0, in multiples of the ray's direction vector
};

/// A ray prepared for intersection with many triangles [Woop, Benthin, Wald 2013, Watertight Ray/Triangle
/// Intersection]. A ray through the common edge or corner of triangles meets at least one of them.
class TriangleRay {
 public:
  explicit TriangleRay(const Ray& ray);

  /// Intersects a triangle from either side. Returns nothing for a triangle that appears as a line along the
  /// ray.
  std::optional<TriangleHit> meet(const Surface& surface, Index triangle) const;

 private:
  /// The corner in a sheared frame in which the ray starts at 0 and its direction is the unit vector along z.
  Vec3d sheared(const Vec3f& corner) const;

  Vec3d origin_;
  int x_, y_, z_;  ///< permuted axes; z is the one with the largest component of the direction
  Vec3d shear_;
};

}  // namespace burin
