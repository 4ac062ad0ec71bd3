#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// Twice the area of a polygon times its normal (Newell), from its first corner to spare digits.
inline Vec3d area_vector(const std::vector<Vec3f>& positions, std::span<const Index> corners) {
  const Vec3d origin = positions[corners[0]].cast<double>();
  Vec3d sum = Vec3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (positions[corners[i]].cast<double>() - origin)
               .cross(positions[corners[i + 1]].cast<double>() - origin);
  return sum;
}

}  // namespace burin
