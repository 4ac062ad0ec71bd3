#pragma once
#include <burin/feature/feature.h>
#include <burin/stroke/camera.h>

#include <string>

namespace burin::command {

/// The camera of a `.stroke` file, whose strokes do not matter, after its world was rotated by `axes`, and
/// relative to `origin`. Throws FileError if the file has none.
Camera read_camera(const std::string& path, const Eigen::Matrix3d& axes, const Vec3d& origin);

/// Where a camera sees a surface from: its eye, wherever its projection puts it, or of a parallel projection
/// its direction of sight.
Viewpoint viewpoint_of(const Camera& camera);

}  // namespace burin::command
