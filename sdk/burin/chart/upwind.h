#pragma once
#include <burin/base/vector.h>

#include <span>

namespace burin {

/// What the front knows at a vertex of the chart.
struct ChartFrame {
  double t = 0;              ///< arc length along the stroke, object units
  float d = 0;               ///< signed geodesic distance to it
  Vec3f e1 = Vec3f::Zero();  ///< unit tangent along the stroke

  bool operator==(const ChartFrame&) const = default;
};

/// P(q) + T_q(x) and R(q, x) e1(q) of one upwind neighbour q of x.
struct Prediction {
  Index from = no_index;
  float length = 0;  ///< |x - q|, object units
  ChartFrame frame;
};

/// Eq. 2 and 3 of the paper: the frame at x, of this unit normal, as the mean of at least one prediction,
/// weighted by 1 / (length + epsilon). Of predictions that disagree by more than two edges only those count
/// that go with the one nearest to the stroke: where the fronts of different parts of the stroke meet, the
/// mean of their coordinates would mean nothing.
ChartFrame upwind_mean(std::span<const Prediction> predictions, const Vec3f& normal, float epsilon);

}  // namespace burin
