// Reads cameras, and finds where they see from.
#include "snap/snap_view.h"

#include <burin/base/error.h>
#include <burin/stroke/move_origin.h>
#include <burin/stroke/stroke_file.h>

#include <Eigen/LU>
#include <cmath>

namespace burin::command {

Camera read_camera(const std::string& path, const Eigen::Matrix3d& axes, const Vec3d& origin) {
  Recording recording = read_strokes(path);
  if (!recording.camera) throw FileError(path, "holds no camera");
  turn(recording, axes);
  move_origin(recording, origin);
  return *recording.camera;
}

Viewpoint viewpoint_of(const Camera& camera) {
  // All lines of sight meet at the point, at infinity for parallel ones, that is projected to (0, 0, 1, 0).
  const Eigen::Vector4d meeting = (camera.projection * camera.view).inverse().col(2);
  constexpr double parallel = 1e-12;
  if (std::abs(meeting.w()) > parallel * meeting.head<3>().norm())
    return {true, meeting.head<3>() / meeting.w()};
  return {false, meeting.head<3>()};
}

}  // namespace burin::command
