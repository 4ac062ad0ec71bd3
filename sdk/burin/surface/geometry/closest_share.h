#pragma once
#include <burin/base/vector.h>

#include <algorithm>

namespace burin {

/// The parameter, from 0 at a to 1 at b, of the segment's point closest to p; 0 for a segment without length.
inline double closest_share(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  const Vec3d edge = b - a;
  const double square = edge.squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(edge) / square, 0.0, 1.0) : 0;
}

}  // namespace burin
