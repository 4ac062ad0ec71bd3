#pragma once
#include <burin/base/vector.h>

namespace burin {

/// A place on a surface: position = u * corner 1 + v * corner 2 + (1 - u - v) * corner 0 of the triangle.
struct SurfacePoint {
  Index triangle = no_index;
  float u = 0, v = 0;
  Vec3f position = Vec3f::Zero();  ///< object units
};

}  // namespace burin
