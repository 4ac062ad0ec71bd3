#pragma once
#include <burin/base/vector.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <optional>

namespace burin {

/// Where a ray meets a triangle: at u * corner 1 + v * corner 2 + (1 - u - v) * corner 0.
struct TriangleHit {
  double u, v;
  double distance;  ///< >= 0, in lengths of the ray's direction
};

/// A ray made ready for many triangles. Watertight: a ray through the common edge or corner of triangles
/// meets at least one of them [Woop, Benthin, Wald 2013, Watertight Ray/Triangle Intersection].
class TriangleRay {
 public:
  explicit TriangleRay(const Ray& ray);

  /// From either side. Nothing for triangles that the ray sees as a line.
  std::optional<TriangleHit> meet(const Surface& surface, Index triangle) const;

 private:
  /// The corner in a frame where the ray starts at 0 and runs along z, as long as its direction.
  Vec3d sheared(const Vec3f& corner) const;

  Vec3d origin_;
  int x_, y_, z_;  ///< axes; z the longest of the direction
  Vec3d shear_;
};

}  // namespace burin
