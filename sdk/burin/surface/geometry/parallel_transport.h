#pragma once
#include <burin/base/vector.h>

namespace burin {

/// Rotates `tangent`, which is at right angles to the unit normal `from`, by the minimal rotation that takes
/// `from` to the unit normal `to`: parallel transport [Schmidt 2013, Eq. 3]. For opposite normals, for which
/// that rotation is not defined, the tangent stays as it is.
inline Vec3f transport(const Vec3f& tangent, const Vec3f& from, const Vec3f& to) {
  const float cosine = from.dot(to);
  if (cosine < -0.999F) return tangent;
  return tangent - (to.dot(tangent) / (1 + cosine)) * (from + to);
}

}  // namespace burin
