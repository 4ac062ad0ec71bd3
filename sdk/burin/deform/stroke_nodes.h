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
  std::vector<NodePen> pen;  ///< [node], or empty when the brush reads nothing of the pen
};

/// `pen_inputs`: of BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME, those that the brush reads and the recording
/// has.
StrokeNodes make_stroke_nodes(Chart chart, const SurfaceCurve& curve, std::uint64_t pen_inputs);

/// The pen inputs that a recording of these fields has.
std::uint64_t pen_inputs_present(const PenFields& fields);

}  // namespace burin
