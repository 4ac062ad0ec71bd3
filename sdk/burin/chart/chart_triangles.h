#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/surface.h>

#include <array>
#include <vector>

// The functions may be called on any thread, also on several at once.
namespace burin {

/// Nodes of a chart at the corners of a triangle that belong to the same visit of the stroke.
struct ChartTriangle {
  Index triangle = no_index;     ///< of the surface
  std::array<Index, 3> nodes{};  ///< nodes of the chart, in the order of the triangle's corners
  std::array<double, 3> t{};     ///< arc lengths of the nodes, object units; on a closed stroke within half
                                 ///< its length of the first, the least in [0, length)
};

/// Groups the nodes at three corners by visit: returns triples of nodes in ascending order, each node in at
/// most one. Nodes can form a triple when their distances in the chart, with t scaled by the stretch, are at
/// most twice the longest edge between the corners, and when they do not wind around a closed stroke. Among
/// triples that share a node the one with the smallest sum of squared distances wins. A corner may be
/// no_index: it matches every node, and the result has no_index there.
std::vector<std::array<Index, 3>> nodes_together(const Surface& surface, const Chart& chart,
                                                 const std::array<Index, 3>& corners);

/// Returns the triangles that cover the chart, ordered by triangle of the surface, then by nodes. Costs O(n
/// log n) for n nodes. A point set has none.
std::vector<ChartTriangle> chart_triangles(const Surface& surface, const Chart& chart);

/// The arc length of a node; on a closed stroke plus the multiple of the length that brings it nearest to
/// `t`.
double t_beside(const Chart& chart, double t, Index node);

}  // namespace burin
