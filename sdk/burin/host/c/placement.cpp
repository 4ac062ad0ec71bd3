#include <burin/host/c/call.h>
#include <burin/host/c/placement.h>

#include <Eigen/LU>
#include <cmath>
#include <utility>

namespace burin::c {
namespace {

/// The volume of the world's image of a unit cube as a share of the box of its edges' lengths, below which it
/// counts as flat: its inverse would lose all digits of floats.
constexpr double flat = 1e-7;

Mat4d checked(const double* matrix) {
  const Mat4d given = Eigen::Map<const Eigen::Matrix4d>(matrix);
  if (!given.allFinite()) reject("transform has a number that is not finite");
  if (given.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    reject("transform is not affine: its last row is not 0, 0, 0, 1");
  const Eigen::Matrix3d linear = given.topLeftCorner<3, 3>();
  const double box = linear.col(0).norm() * linear.col(1).norm() * linear.col(2).norm();
  if (!(std::abs(linear.determinant()) > flat * box) || !std::isfinite(box))
    reject("transform has no inverse: it makes the object flat");
  return given;
}

}  // namespace

Placement::Placement(const double* matrix)
    : to_world_(checked(matrix)),
      to_object_(Eigen::Matrix4d(to_world_).inverse()),
      mirrors_(to_world_.topLeftCorner<3, 3>().determinant() < 0) {
  if (!to_object_.allFinite()) reject("transform has no inverse: it makes the object flat");
}

Vec3f Placement::moved(const Mat4d& by, const Vec3f& position) {
  Vec3f result;
  const Vec3d p = position.cast<double>();
  for (int axis = 0; axis < 3; ++axis)
    result[axis] =
        static_cast<float>(by(axis, 0) * p.x() + by(axis, 1) * p.y() + by(axis, 2) * p.z() + by(axis, 3));
  return result;
}

Vec3f Placement::normal_to_object(const Vec3f& normal) const {
  const Vec3d n = normal.cast<double>();
  Vec3d result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = to_world_(0, axis) * n.x() + to_world_(1, axis) * n.y() + to_world_(2, axis) * n.z();
  const double length =
      std::sqrt(result.x() * result.x() + result.y() * result.y() + result.z() * result.z());
  return (result / length).cast<float>();
}

void turn_over(std::span<Triangle> triangles) {
  for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
}

}  // namespace burin::c
