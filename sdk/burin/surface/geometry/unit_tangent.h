#pragma once
#include <burin/base/vector.h>

#include <cmath>

namespace burin {

/// The unit vector of `direction` projected to the plane at right angles to the unit vector `normal`; an
/// arbitrary unit tangent if `direction` is parallel to `normal`.
inline Vec3f unit_tangent(const Vec3f& direction, const Vec3f& normal) {
  // The squares of smaller or greater components are not normal floats.
  const float size = direction.cwiseAbs().maxCoeff();
  if ((size > 0 && size < 1e-15F) || (size > 1e18F && std::isfinite(size)))
    return unit_tangent(direction / size, normal);
  const Vec3f tangent = direction - normal.dot(direction) * normal;
  const float length = tangent.norm();
  if (length > 1e-6F * direction.norm()) return tangent / length;
  return normal.unitOrthogonal();
}

}  // namespace burin
