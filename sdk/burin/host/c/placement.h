#pragma once
#include <burin/base/vector.h>
#include <burin/surface/triangle_mesh.h>

#include <span>

namespace burin::c {

/// Where an object lies in the world: an affine map that has an inverse. Strokes are drawn in the world, so
/// that brushes are round there. Computed axis by axis in doubles, so that results do not depend on the
/// machine.
class Placement {
 public:
  /// `matrix`: 4 x 4, by columns, from object to world. Throws plugin::Error for one that is not finite, not
  /// affine, or that makes solids flat.
  explicit Placement(const double* matrix);

  Vec3f to_world(const Vec3f& position) const { return moved(to_world_, position); }

  /// The inverse of to_world() but for rounding.
  Vec3f to_object(const Vec3f& position) const { return moved(to_object_, position); }

  /// The object's unit normal where the world's is this: outward stays outward, also with a mirroring.
  Vec3f normal_to_object(const Vec3f& normal) const;

  /// Whether what is counter-clockwise in the object is clockwise in the world.
  bool mirrors() const { return mirrors_; }

 private:
  static Vec3f moved(const Mat4d& by, const Vec3f& position);

  Mat4d to_world_, to_object_;
  bool mirrors_;
};

/// The triangles turned over, as a mirroring wants.
void turn_over(std::span<Triangle> triangles);

}  // namespace burin::c
