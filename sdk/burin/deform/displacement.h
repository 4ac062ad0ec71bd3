#pragma once
#include <burin/base/vector.h>

namespace burin {

/// `base` moved by (x along e1, y along e2 = n x e1, z along n). No displacement gives the bits of `base`.
inline Vec3f displaced(const Vec3f& base, const Vec3f& e1, const Vec3f& n, const Vec3f& displacement) {
  if (displacement.x() == 0 && displacement.y() == 0 && displacement.z() == 0) return base;
  const Vec3f e2 = n.cross(e1);
  Vec3f position;
  for (int k = 0; k < 3; ++k)
    position[k] = base[k] + ((e1[k] * displacement.x() + e2[k] * displacement.y()) + n[k] * displacement.z());
  return position;
}

}  // namespace burin
