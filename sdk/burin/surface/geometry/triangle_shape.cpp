// Takes the cross product of two edges in doubles, which is zero for triangles without area.
#include <burin/surface/geometry/triangle_shape.h>

#include <Eigen/Geometry>

namespace burin {

bool has_area(const std::vector<Vec3f>& positions, const Triangle& triangle) {
  const auto corner = [&](int i) -> Vec3d { return positions[triangle[i]].cast<double>(); };
  return !(corner(1) - corner(0)).cross(corner(2) - corner(0)).isZero(0);
}

}  // namespace burin
