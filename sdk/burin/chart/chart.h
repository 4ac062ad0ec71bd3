#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// The coordinates (t, d) of the region around a stroke [R. Schmidt, Stroke Parameterization, 2013], as a
/// structure of arrays. A node is a pair of a vertex and a visit of the stroke to it: where the stroke
/// overlaps itself a vertex has several nodes, its sheets. Each node has a right-handed frame (e1, e2 = n x
/// e1, n). d is positive on the left of the direction of travel, which is the direction of e2 (the sign
/// formula in section 2 of the paper gives the right).
struct Chart {
  std::vector<Index> vertex;         ///< vertex of the surface, ascending; once for each of its sheets
  std::vector<std::uint32_t> sheet;  ///< 0, 1, ... at each vertex, in the order of t
  std::vector<double> t;      ///< arc length along the stroke, object units; in [0, length) on a closed
                              ///< stroke; beyond [0, length] in round caps, where t and d are geodesic
                              ///< normal coordinates around the end
  std::vector<float> d;       ///< signed geodesic distance to the stroke, object units, |d| <= radius
  std::vector<Vec3f> e1;      ///< unit, at right angles to the normal, along the stroke
  std::vector<Vec3f> normal;  ///< unit normal of the surface, or of the base surface if the stroke runs on it
  std::vector<float> stretch;    ///< J = |dP/dt|, 1 on the stroke; 1 everywhere in charts of first order
  std::vector<float> curvature;  ///< k: geodesic curvature of the line of constant d, 1 / length; in round
                                 ///< caps stretch and curvature mean what DistanceRay defines
  double length = 0;             ///< length of the stroke, object units
  bool closed = false;           ///< the stroke is closed: t is periodic with `length`

  std::size_t size() const { return vertex.size(); }  ///< number of nodes
  /// Of one node.
  ChartFrame frame(std::size_t node) const {
    return {
        .t = t[node], .d = d[node], .e1 = e1[node], .curvature = curvature[node], .stretch = stretch[node]};
  }

  /// All of one node.
  void set(std::size_t node, Index of_vertex, std::uint32_t of_sheet, const ChartFrame& frame,
           const Vec3f& unit_normal) {
    vertex[node] = of_vertex;
    sheet[node] = of_sheet;
    normal[node] = unit_normal;
    set_frame(node, frame);
  }

  /// Of one node.
  void set_frame(std::size_t node, const ChartFrame& frame) {
    t[node] = frame.t;
    d[node] = frame.d;
    e1[node] = frame.e1;
    stretch[node] = frame.stretch;
    curvature[node] = frame.curvature;
  }

  /// Changes the number of nodes.
  void resize(std::size_t nodes) {
    vertex.resize(nodes);
    sheet.resize(nodes);
    t.resize(nodes);
    d.resize(nodes);
    e1.resize(nodes);
    normal.resize(nodes);
    stretch.resize(nodes);
    curvature.resize(nodes);
  }
};

}  // namespace burin
