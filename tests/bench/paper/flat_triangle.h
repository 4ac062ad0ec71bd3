#pragma once
#include <array>

#include "support/oracles/region.h"

namespace burin::paper {

/// Plane coordinates (u, v) of a region's vertices, one row each.
using Parameterization = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// A triangle laid into the plane, counter-clockwise, without stretching.
struct FlatTriangle {
  std::array<Vec2d, 3> corners;        ///< object units
  std::array<double, 3> edge_weights;  ///< half the cotangent opposite to the edge from corner i to i + 1
};

/// The flattened triangles of a region. A triangle without area has the weights 0 and does not influence the
/// result.
std::vector<FlatTriangle> flatten(const Surface& surface, const test::Region& region);

}  // namespace burin::paper
