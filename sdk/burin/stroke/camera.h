#pragma once
#include <burin/base/vector.h>
#include <burin/surface/picker.h>

namespace burin {

/// A view with OpenGL's conventions: clip = projection * view * (position, 1), z towards the viewer.
struct Camera {
  Mat4d view = Mat4d::Identity();
  Mat4d projection = Mat4d::Identity();
  int width = 0, height = 0;  ///< viewport, pixels
};

/// The ray through a place of the viewport; pixels from the top left corner, centres at .5. It starts on
/// the near plane and its direction is a unit vector. The matrices must have an inverse.
Ray pixel_ray(const Camera& camera, double x, double y);

/// A perspective camera that looks along `direction` at the middle of the box and shows all of it, with
/// some air around it. field_of_view: vertical, radians, below pi. An `up` along `direction` is replaced.
/// Throws ContractError: a viewport, box, direction or field of view without extent or not finite.
Camera framing_camera(const Vec3d& box_min, const Vec3d& box_max, const Vec3d& direction, const Vec3d& up,
                      int width, int height, double field_of_view);

}  // namespace burin
