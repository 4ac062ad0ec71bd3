#pragma once
#include <burin/base/vector.h>

#include <array>

namespace burin {

/// A place on a surface between three of its vertices: the triangle it lies in, or points around it in a
/// point set. What is known at the vertices is known there as the sum of weights[i] * value(corners[i]).
struct SurfacePoint {
  Index triangle = no_index;  ///< no_index on a point set
  std::array<Index, 3> corners = {no_index, no_index, no_index};
  std::array<float, 3> weights = {0, 0, 0};  ///< >= 0, of sum 1
  Vec3f position = Vec3f::Zero();            ///< object units
};

}  // namespace burin
