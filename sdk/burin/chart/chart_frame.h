#pragma once
#include <burin/base/vector.h>

namespace burin {

/// The least stretch that frames have. A smaller one means that a focal point is near, where Fermi
/// coordinates fold, and is raised to this.
constexpr float least_stretch = 0.15F;

/// The Fermi coordinates of a node, in which the metric is J^2 dt^2 + dd^2, with their first and second
/// derivatives. Beyond round ends the members mean what DistanceRay defines.
struct ChartFrame {
  double t = 0;              ///< arc length along the stroke, object units
  float d = 0;               ///< signed geodesic distance to the stroke, object units, left positive
  Vec3f e1 = Vec3f::Zero();  ///< unit tangent of the line of constant d
  float curvature = 0;       ///< k: geodesic curvature of that line, 1 / length, positive to the left
  float stretch = 1;         ///< J = |dP/dt|; k = -J' / J, J'' = -K J along d, J = 1 on the stroke

  bool operator==(const ChartFrame&) const = default;
};

}  // namespace burin
