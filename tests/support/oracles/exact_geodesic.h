#pragma once
#include <burin/chart/chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin::test {

/// A chart node measured by exact polyhedral geodesics. Lengths are in object units.
struct ExactNode {
  std::size_t node;          ///< index of the node in the chart
  double distance;           ///< distance of the vertex from the stroke, near the node's own t
  double distance_to_own_t;  ///< distance to the stroke's point at the node's t; not less than `distance`
  double t;                  ///< arc length of the nearest point
  /// Half the second derivative of the squared distance along the stroke: 1 beside straight lines in the
  /// plane, 0 at focal points, where the nearest point is undetermined.
  double convexity;
};

/// Measures the nodes of a chart of this curve. The stroke's point nearest to a node is searched within a
/// fifth of the radius around the node's t, by a parabola through the squared distances of points of the
/// curve; distances are exact to about 1e-4 of the radius. Nodes without a nearest point in that range are
/// left out, and so are nodes where the surface is not an oriented manifold.
std::vector<ExactNode> exact_nodes(const Surface& surface, const SurfaceCurve& curve, const Chart& chart,
                                   double radius, std::span<const std::size_t> nodes);

}  // namespace burin::test
