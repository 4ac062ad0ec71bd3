#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/surface.h>

#include <array>
#include <vector>

namespace burin {

/// Nodes of a chart at the corners of a triangle that belong to the same visit of the stroke.
struct ChartTriangle {
  Index triangle = no_index;     ///< of the surface
  std::array<Index, 3> nodes{};  ///< of the chart, in the order of the triangle's corners
  std::array<double, 3> t{};     ///< of the nodes, object units; of a closed stroke within half its
                                 ///< length of each other, the least in [0, length)
};

/// Every way in which nodes at these corners belong together, each node in one at most: where the runs of a
/// bend meet, the nodes that are closest to each other. Nodes belong together that lie no farther apart in
/// the chart, t counted at its stretch, than two of the longest edge between the corners, and do not stand
/// around a closed stroke. In a corner that is no_index any node will do, and there is none in the result. In
/// the order of the nodes.
std::vector<std::array<Index, 3>> nodes_together(const Surface& surface, const Chart& chart,
                                                 const std::array<Index, 3>& corners);

/// The triangles that cover the chart, by triangle of the surface, then nodes. Costs in proportion to the
/// chart, but for the logarithm. Of a point set there are none.
std::vector<ChartTriangle> chart_triangles(const Surface& surface, const Chart& chart);

/// The arc length of a node as it is counted beside `t`: on a closed stroke the turn of it that is nearest.
double t_beside(const Chart& chart, double t, Index node);

}  // namespace burin
