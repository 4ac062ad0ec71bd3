#pragma once
#include <burin/base/vector.h>

#include <span>

namespace burin {

/// The coordinates and the frame of a dab at a vertex.
struct DabFrame {
  Vec2f at = Vec2f::Zero();  ///< T_p(x), object units
  Vec3f e1 = Vec3f::Zero();  ///< unit tangent
};

/// The frame of x predicted from one upwind neighbour q: T_p(q) + T_q(x) and R(q, x) e1(q).
struct DabPrediction {
  Index from = no_index;
  float g = 0;       ///< graph distance of x from the centre through q, object units
  float length = 0;  ///< |x - q|, object units
  DabFrame frame;
};

/// The mean of at least one prediction, weighted by 1 / (length + epsilon). e1 is their mean direction,
/// projected to the plane at right angles to `normal`. Predictions count only if they agree, within two
/// edges, with the prediction of the shortest path: behind a horn, where the front meets itself, the
/// coordinates of the two sides must not be averaged.
DabFrame upwind_mean(std::span<const DabPrediction> predictions, const Vec3f& normal, float epsilon);

}  // namespace burin
