#pragma once
#include <burin/base/vector.h>
#include <burin/surface/picker.h>

// The functions may be called on any thread, also on several at once.
namespace burin {

/// A camera with OpenGL's conventions: clip = projection * view * (position, 1); eye space has z towards the
/// viewer.
struct Camera {
  Mat4d view = Mat4d::Identity();
  Mat4d projection = Mat4d::Identity();
  int width = 0, height = 0;  ///< viewport, pixels
};

/// The ray through the point (x, y) of the viewport, in pixels from the top left corner with pixel centres at
/// .5. It starts on the near plane; its direction is a unit vector. The product of the matrices must be
/// invertible.
Ray pixel_ray(const Camera& camera, double x, double y);

/// A perspective camera that looks along `direction` at the centre of the box and shows all of it with a
/// margin of 5 %. field_of_view is vertical, radians, below pi. An `up` parallel to `direction` is replaced.
/// Throws ContractError if viewport, box, direction or field of view is empty or not finite.
Camera framing_camera(const Vec3d& box_min, const Vec3d& box_max, const Vec3d& direction, const Vec3d& up,
                      int width, int height, double field_of_view);

}  // namespace burin
