#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/frames/circle_step.h>
#include <burin/chart/frames/frame_step.h>

#include <algorithm>

namespace burin {

/// The frame that one at q tells of x, taking lines of constant d for circles. `step`: from q to x, with e1
/// carried there. `normal`: at x. `gauss`: curvature of the surface along the way, 1 / area.
inline ChartFrame frame_on_circles(const ChartFrame& at_q, const FrameStep& step, const Vec3f& normal,
                                   float gauss) {
  const float k = at_q.curvature;
  const CircleStep circle = circle_step(step.step.x(), step.step.y(), k, at_q.d);
  const float bulge = gauss * circle.across;
  return {.t = at_q.t + static_cast<double>(circle.along / at_q.stretch),
          .d = at_q.d + circle.across,
          .e1 = circle.cosine * step.e1 + circle.sine * normal.cross(step.e1),
          .curvature = k / std::max(circle.size, least_stretch) + bulge,
          .stretch = std::max(at_q.stretch * (circle.size - bulge * circle.across / 2), least_stretch)};
}

}  // namespace burin
