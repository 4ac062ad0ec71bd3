#pragma once
#include <burin/chart/chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin::test {

/// What exact polyhedral geodesics say of a chart node. Lengths in object units.
struct ExactNode {
  std::size_t node;          ///< of the chart
  double distance;           ///< from the vertex to the stroke, near the node's own t
  double distance_to_own_t;  ///< to the stroke's point at the node's t; never the shorter one
  double t;                  ///< of the nearest point
  /// Half the second derivative of the squared distance along the stroke: 1 beside straight lines in the
  /// plane, 0 at focal points, where the nearest point is undetermined.
  double convexity;
};

/// Measures nodes of a chart of this curve. The stroke's point nearest to a node is looked for within a
/// fifth of the radius around the node's t, by a parabola through the squared distances of the points of
/// the curve, so distances are exact to about 1e-4 of the radius. Left out are nodes for which no nearest
/// point lies there, and places where the surface is no manifold with consistent orientation.
std::vector<ExactNode> exact_nodes(const Surface& surface, const SurfaceCurve& curve, const Chart& chart,
                                   double radius, std::span<const std::size_t> nodes);

}  // namespace burin::test
