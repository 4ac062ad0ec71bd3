#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/frame_step.h>

#include <span>
#include <vector>

namespace burin {

/// An upwind neighbour q of a vertex x.
struct UpwindArm {
  Index from = no_index;  ///< vertex q
  ChartFrame frame;       ///< at q; t unwrapped so that all arms of a vertex lie on one line
  FrameStep edge;         ///< from q to x
  float length = 0;       ///< |x - q|, object units
  float gauss = 0;        ///< Gauss curvature along the edge, 1 / length^2
};

/// Leaves of the arms, at least one, those that go with the one that places x nearest to the stroke: where
/// fronts of different parts of the stroke meet, the mean of their coordinates would mean nothing. Arms
/// agree that place x no farther apart than two edges.
void keep_agreeing(std::vector<UpwindArm>& arms);

/// The frame at x, of this unit normal, from at least one arm: Eq. 2 and 3 of the paper, weighted by
/// 1 / (length + epsilon). Curvature and stretch stay those of a straight stroke on a plane.
ChartFrame first_order_frame(std::span<const UpwindArm> arms, const Vec3f& normal, float epsilon);

/// The same, to second order in the length of the arms, on curved strokes and surfaces. Near focal points,
/// where no such frame is, the first order.
ChartFrame second_order_frame(std::span<const UpwindArm> arms, const Vec3f& normal, float epsilon);

}  // namespace burin
