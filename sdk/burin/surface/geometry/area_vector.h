#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// The unit normal of a polygon times twice its area (Newell's method), computed relative to the first corner
/// to limit rounding.
inline Vec3d area_vector(const std::vector<Vec3f>& positions, std::span<const Index> corners) {
  const Vec3d origin = positions[corners[0]].cast<double>();
  Vec3d sum = Vec3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (positions[corners[i]].cast<double>() - origin)
               .cross(positions[corners[i + 1]].cast<double>() - origin);
  return sum;
}

}  // namespace burin
