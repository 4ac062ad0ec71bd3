#pragma once
#include <burin/base/rising_threshold.h>
#include <burin/chart/live_chart.h>
#include <burin/deform/evaluate/node_dynamics.h>
#include <burin/stroke/curve/surface_curve.h>

#include <cstdint>
#include <limits>
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

/// What an event left to be done, in the order in which nodes and vertices turned up.
struct StrokeChanges {
  std::vector<Index> stale;     ///< slots whose outputs must be computed
  std::vector<Index> vertices;  ///< that have stale nodes, or lost one; each once
};

/// What a brush may read of a stroke's nodes.
struct ReadInputs {
  double radius = 0;          ///< of the stroke where its width is 1, object units
  std::uint64_t inputs = 0;   ///< that the brush reads
  std::uint64_t varying = 0;  ///< of BURIN_INPUT_RADIUS and BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME, those
                              ///< to keep that may differ along the stroke
  const ParamDynamics* dynamics = nullptr;  ///< of strength and parameters; must outlive the nodes
};

/// All that differs from node to node while a stroke grows.
class StrokeNodes {
 public:
  /// The chart, which must outlive the object, is empty yet.
  StrokeNodes(const LiveChart& chart, const ReadInputs& reads)
      : chart_(&chart), reads_(reads), dynamics_(reads.dynamics), zone_(reads.radius / 8) {}

  /// Follows the last event of the chart, of this curve. Nodes are stale that are new, whose inputs differ in
  /// any bit, or whose t is at least `end_zone`: there the brush may look at the stroke's length. Up to the t
  /// of `same_pen_up_to` the pen is known to be as before.
  StrokeChanges follow(const SurfaceCurve& curve, double end_zone,
                       double same_pen_up_to = -std::numeric_limits<double>::infinity());

  /// What is stale for the end zone alone.
  StrokeChanges in_zone(double end_zone);

  const LiveChart& live() const { return *chart_; }
  const Chart& chart() const { return chart_->nodes(); }

  /// Of the stroke at the node's t, [slot]; empty where nobody asks for it.
  const std::vector<float>& half_width() const { return half_width_; }
  const std::vector<NodePen>& pen() const { return pen_; }
  const NodeDynamics& dynamics() const { return dynamics_; }

 private:
  void collect(double same_pen_up_to);
  void compare_pens(const SurfaceCurve& curve);
  void add_stale(Index slot);
  void add_vertex(Index slot);
  void add_other_sheets();
  void add_zone(double end_zone, double up_to);
  double t_of(Index slot) const;
  StrokeChanges finished();

  const LiveChart* chart_;
  ReadInputs reads_;
  std::vector<float> half_width_;
  std::vector<NodePen> pen_;
  NodeDynamics dynamics_;

  RisingThreshold zone_;
  StrokeChanges changes_;
  bool altered_listed_ = false;  ///< changes_ has the vertices that the chart's last event altered
  std::uint32_t event_ = 0;
  std::vector<std::uint32_t> stale_in_, vertex_in_;  ///< [slot], [place of the chart]: event
  std::vector<Index> asked_;                         ///< slots whose pen, half width or dynamics may differ
  std::vector<std::uint8_t> differs_;                ///< [i of asked_]
};

/// The pen inputs that a recording of these fields has.
std::uint64_t pen_inputs_present(const PenFields& fields);

}  // namespace burin
