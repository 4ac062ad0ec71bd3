#pragma once
#include <burin/base/vector.h>

namespace burin {

/// Below this stretch a focal point is near, where Fermi coordinates fold.
constexpr float least_stretch = 0.15F;

/// What the front knows at a node of the chart: the Fermi coordinates of the stroke, in which the metric is
/// J^2 dt^2 + dd^2, and how they go on. Beyond round ends its members mean what DistanceRay says.
struct ChartFrame {
  double t = 0;              ///< arc length along the stroke, object units
  float d = 0;               ///< signed geodesic distance to it
  Vec3f e1 = Vec3f::Zero();  ///< unit tangent of the line of constant d
  float curvature = 0;       ///< k: geodesic curvature of that line, 1 / length, positive to the left
  float stretch = 1;         ///< J = |dP/dt|; k = -J' / J, J'' = -K J along d, J = 1 on the stroke

  bool operator==(const ChartFrame&) const = default;
};

}  // namespace burin
