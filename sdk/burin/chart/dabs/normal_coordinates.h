#pragma once
#include <burin/base/vector.h>

#include <span>

namespace burin {

/// What a dab knows at a vertex.
struct DabFrame {
  Vec2f at = Vec2f::Zero();  ///< T_p(x), object units
  Vec3f e1 = Vec3f::Zero();  ///< unit tangent
};

/// T_p(q) + T_q(x) and R(q, x) e1(q) of one upwind neighbour q of x.
struct DabPrediction {
  Index from = no_index;
  float g = 0;       ///< graph distance of x from the centre through q, object units
  float length = 0;  ///< |x - q|, object units
  DabFrame frame;
};

/// The mean of at least one prediction, weighted by 1 / (length + epsilon). e1 is their mean direction in
/// the plane at right angles to `normal`. Of predictions that disagree by more than two edges only those
/// count that go with the one of the shortest path: behind a horn, where the front meets itself, the mean of
/// both sides would mean nothing.
DabFrame upwind_mean(std::span<const DabPrediction> predictions, const Vec3f& normal, float epsilon);

}  // namespace burin
