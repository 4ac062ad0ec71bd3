#pragma once
#include <burin/surface/triangle_mesh.h>

#include <Eigen/Geometry>
#include <vector>

namespace burin {

/// The bounding box of a triangle.
inline Eigen::AlignedBox3f triangle_box(const std::vector<Vec3f>& positions, const Triangle& triangle) {
  Eigen::AlignedBox3f box;
  for (const Index corner : triangle) box.extend(positions[corner]);
  return box;
}

}  // namespace burin
