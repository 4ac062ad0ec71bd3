#pragma once
#include <burin/base/vector.h>

namespace burin {

/// Converts components (x along e1, y along e2 = n x e1, z along n) to object space.
template <class Vector>
Vector in_space(const Vector& e1, const Vector& n, const Vector& components) {
  return e1 * components.x() + n.cross(e1) * components.y() + n * components.z();
}

/// Converts a vector in object space to components along (e1, e2 = n x e1, n).
template <class Vector>
Vector in_frame(const Vector& e1, const Vector& n, const Vector& vector) {
  return {e1.dot(vector), n.cross(e1).dot(vector), n.dot(vector)};
}

/// `base` plus the displacement (x along e1, y along e2 = n x e1, z along n). A zero displacement keeps the
/// bits of `base`.
inline Vec3f displaced(const Vec3f& base, const Vec3f& e1, const Vec3f& n, const Vec3f& displacement) {
  if (displacement.x() == 0 && displacement.y() == 0 && displacement.z() == 0) return base;
  return base + in_space(e1, n, displacement);
}

}  // namespace burin
