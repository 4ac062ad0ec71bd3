#pragma once
#include <burin/base/vector.h>

#include <array>

namespace burin {

/// A point of a surface, given by three vertices: the corners of the triangle it lies in, or points around it
/// in a point set. A vertex attribute is interpolated as the sum of weights[i] * value(corners[i]).
struct SurfacePoint {
  Index triangle = no_index;  ///< no_index on a point set
  std::array<Index, 3> corners = {no_index, no_index, no_index};
  std::array<float, 3> weights = {0, 0, 0};  ///< >= 0; their sum is 1
  Vec3f position = Vec3f::Zero();            ///< object units
};

}  // namespace burin
