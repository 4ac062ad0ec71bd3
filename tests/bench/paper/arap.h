#pragma once
#include "dncp.h"

namespace burin::paper {

/// As-rigid-as-possible parameterization [Liu, Zhang, Xu, Gotsman and Gortler 2008]: the local and the global
/// step in turns, `iterations` times, from initial places. Throws Error when the constraints do not hold the
/// region.
Parameterization arap(std::span<const FlatTriangle> triangles, const test::Region& region,
                      std::span<const Constraint> constraints, Parameterization initial, int iterations,
                      SolveTimes& times);

/// The energy that it lowers: area-weighted squared distance of each triangle's map from a rotation, over the
/// region's area.
double arap_energy(std::span<const FlatTriangle> triangles, const test::Region& region,
                   const Parameterization& places);

}  // namespace burin::paper
