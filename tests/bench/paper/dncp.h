#pragma once
#include "constraints.h"

namespace burin::paper {

/// Seconds that a parameterization took.
struct SolveTimes {
  double setup = 0;  ///< matrix and factors
  double solve = 0;
};

/// Discrete natural conformal parameterization [Desbrun, Meyer and Alliez 2002]: least Dirichlet energy less
/// area, with a free boundary, under at least two constraints at different places.
/// Throws Error when they do not hold the region.
Parameterization dncp(std::span<const FlatTriangle> triangles, const test::Region& region,
                      std::span<const Constraint> constraints, SolveTimes& times);

}  // namespace burin::paper
