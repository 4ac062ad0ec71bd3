#pragma once
#include <burin/chart/frames/frame_on_circles.h>
#include <burin/chart/path/distance_ray.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <cmath>

namespace burin {

/// Extrapolates a frame at q, beyond a round end of the stroke, to x. The parameters are those of
/// propagate_frame().
inline ChartFrame propagate_around_end(const ChartFrame& at_q, const DistanceRay& ray, const FrameStep& step,
                                       const Vec3f& normal, float gauss) {
  const float inverse_stretch = 1 / at_q.stretch;
  const Vec2f change = ray_step(ray, at_q.curvature, inverse_stretch, step.step.x(), step.step.y());
  const float turn =
      turn_across(ray, at_q.curvature, inverse_stretch) * in_parts(ray, step.step.x(), step.step.y()).across;
  const float to = Vec2f(ray.length * ray.ahead + change.x(), at_q.d + change.y()).norm();
  ChartFrame frame{.t = at_q.t + static_cast<double>(change.x()),
                   .d = at_q.d + change.y(),
                   .e1 = unit_tangent(step.e1 + turn * normal.cross(step.e1), normal)};
  if (!(to > 0)) return frame;
  const auto [curvature, stretch] = farther_out<float>({at_q.curvature, at_q.stretch}, ray.length, to, gauss);
  if (!(stretch > least_stretch)) {
    frame.stretch = least_stretch;
    return frame;
  }
  frame.curvature = curvature;
  frame.stretch = stretch;
  return frame;
}

/// Extrapolates the frame at q to x. `ray` is the distance ray at q; `step` leads from q to x and has e1
/// transported to x; `normal` is the unit normal at x; `gauss` is the Gauss curvature along the way, 1 /
/// length^2.
inline ChartFrame propagate_frame(const ChartFrame& at_q, const DistanceRay& ray, const FrameStep& step,
                                  const Vec3f& normal, float gauss) {
  return ray.from_end() ? propagate_around_end(at_q, ray, step, normal, gauss)
                        : frame_on_circles(at_q, step, normal, gauss);
}

}  // namespace burin
