#pragma once
#include <burin/chart/chart.h>
#include <burin/stroke/surface_curve.h>

#include <cstdint>
#include <vector>

namespace burin {

/// The pen at a node's t, in the units of burin_batch. Fields that nobody reads or that the recording lacks
/// hold the neutral values.
struct NodePen {
  float pressure = 1;
  float tilt_x = 0, tilt_y = 0;
  float twist = 0;
  float speed = 0;
  float time = 0;

  bool operator==(const NodePen&) const = default;
};

/// All that differs from node to node while a stroke grows.
struct StrokeNodes {
  Chart chart;
  std::vector<float> half_width;  ///< of the stroke at the node's t, [node]; empty where nobody asks for it
  std::vector<NodePen> pen;       ///< [node], or empty when the brush reads nothing of the pen
};

/// `varying`: of BURIN_INPUT_RADIUS and BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME, those that the brush reads
/// and that may differ along the stroke. `radius`: of the stroke where its width is 1, object units.
StrokeNodes make_stroke_nodes(Chart chart, const SurfaceCurve& curve, double radius, std::uint64_t varying);

/// The end of the nodes of the vertex that this node belongs to, which stand one after the other.
inline Index sheets_end(const Chart& chart, Index node) {
  const auto size = static_cast<Index>(chart.size());
  Index end = node + 1;
  while (end < size && chart.vertex[end] == chart.vertex[node]) ++end;
  return end;
}

/// The pen inputs that a recording of these fields has.
std::uint64_t pen_inputs_present(const PenFields& fields);

}  // namespace burin
