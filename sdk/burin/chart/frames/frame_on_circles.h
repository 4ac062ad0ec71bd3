#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/frames/circle_step.h>
#include <burin/chart/frames/frame_step.h>

#include <algorithm>

namespace burin {

/// Extrapolates the frame at q to x, with lines of constant d approximated by circles. `step` leads from q to
/// x and has e1 transported to x; `normal` is the unit normal at x; `gauss` is the Gauss curvature along the
/// way, 1 / length^2.
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
