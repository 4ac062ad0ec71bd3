// Rays through pixels, and a camera that frames a box.
#include <burin/base/error.h>
#include <burin/math/elementary.h>
#include <burin/stroke/camera.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

/// The rotation from world axes to eye axes; its rows are right, up and backwards.
Eigen::Matrix3d eye_axes(const Vec3d& direction, const Vec3d& up) {
  const Vec3d back = -direction.normalized();
  Vec3d right = up.cross(back);
  if (right.norm() <= 1e-9 * up.norm()) right = back.unitOrthogonal();
  right.normalize();
  Eigen::Matrix3d axes;
  axes << right.transpose(), back.cross(right).transpose(), back.transpose();
  return axes;
}

/// OpenGL's perspective matrix; tan_x and tan_y are the tangents of half the fields of view.
Eigen::Matrix4d perspective(double tan_x, double tan_y, double near, double far) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = 1 / tan_x;
  matrix(1, 1) = 1 / tan_y;
  matrix(2, 2) = (near + far) / (near - far);
  matrix(2, 3) = 2 * near * far / (near - far);
  matrix(3, 2) = -1;
  return matrix;
}

/// The corners of a box relative to its centre, in eye axes, one per column.
Eigen::Matrix<double, 3, 8> box_corners(const Eigen::Matrix3d& axes, const Vec3d& half) {
  Eigen::Matrix<double, 3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3d sign((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    corners.col(i) = axes * half.cwiseProduct(sign);
  }
  return corners;
}

void check_frame(const Vec3d& half, const Vec3d& direction, const Vec3d& up, int width, int height,
                 double field_of_view) {
  if (!half.allFinite() || half.minCoeff() < 0) throw ContractError("framing camera: the box is empty");
  if (!direction.allFinite() || !up.allFinite() || direction.norm() == 0)
    throw ContractError("framing camera: the direction has no length or is not finite");
  if (width <= 0 || height <= 0) throw ContractError("framing camera: the viewport is empty");
  if (!(field_of_view > 0 && field_of_view < std::numbers::pi))
    throw ContractError("framing camera: the field of view is not between 0 and pi");
}

}  // namespace

Ray pixel_ray(const Camera& camera, double x, double y) {
  const Eigen::Matrix4d to_world = (camera.projection * camera.view).inverse();
  const double ndc_x = 2 * x / camera.width - 1;
  const double ndc_y = 1 - 2 * y / camera.height;
  const Eigen::Vector4d near = to_world * Eigen::Vector4d(ndc_x, ndc_y, -1, 1);
  const Eigen::Vector4d far = to_world * Eigen::Vector4d(ndc_x, ndc_y, 1, 1);
  const Vec3d origin = near.head<3>() / near.w();
  // This scales far / far.w - origin by far.w, which is 0 for a far plane at infinity and positive otherwise.
  const Vec3d direction = far.head<3>() - far.w() * origin;
  return {origin.cast<float>(), direction.normalized().cast<float>()};
}

Camera framing_camera(const Vec3d& box_min, const Vec3d& box_max, const Vec3d& direction, const Vec3d& up,
                      int width, int height, double field_of_view) {
  constexpr double air = 1.05;
  const Vec3d half = (box_max - box_min) / 2;
  check_frame(half, direction, up, width, height, field_of_view);

  const Eigen::Matrix3d axes = eye_axes(direction, up);
  const Eigen::Matrix<double, 3, 8> corners = box_corners(axes, half);
  const double tan_y = math::tan(field_of_view / 2);
  const double tan_x = tan_y * width / height;
  const double reach = half.norm() > 0 ? half.norm() : 1;

  // The least distance at which every corner is within the frame and none is behind the eye.
  double distance = corners.row(2).maxCoeff() + 0.01 * reach;
  for (const auto& corner : corners.colwise()) {
    const double aside = std::max(std::abs(corner.x()) / tan_x, std::abs(corner.y()) / tan_y);
    distance = std::max(distance, corner.z() + air * aside);
  }

  Camera camera;
  camera.view.topLeftCorner<3, 3>() = axes;
  camera.view.topRightCorner<3, 1>() = -axes * (box_min + half) - Vec3d(0, 0, distance);
  const double nearest = distance - corners.row(2).maxCoeff();
  camera.projection = perspective(tan_x, tan_y, nearest / 2, distance + 2 * reach);
  camera.width = width;
  camera.height = height;
  return camera;
}

}  // namespace burin
