#pragma once
#include <burin/base/rising_threshold.h>
#include <burin/chart/live_chart.h>
#include <burin/deform/evaluate/node_dynamics.h>
#include <burin/stroke/curve/end_distances.h>
#include <burin/stroke/curve/surface_curve.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace burin {

/// The pen at a node's t, in the units of burin_batch. Fields that the brush does not read or that the
/// recording lacks have neutral values.
struct NodePen {
  float pressure = 1;
  float tilt_x = 0, tilt_y = 0;
  float twist = 0;
  float speed = 0;
  float time = 0;

  bool operator==(const NodePen&) const = default;
};

/// The nodes and vertices that an event changed, in order of discovery.
struct StrokeChanges {
  std::vector<Index> stale;     ///< slots whose outputs must be computed
  std::vector<Index> vertices;  ///< vertices that have stale nodes, or lost a node; each once
};

/// What a brush may read of a stroke's nodes.
struct ReadInputs {
  double radius = 0;          ///< half width of the stroke at width 1, object units
  std::uint64_t inputs = 0;   ///< the inputs that the brush reads
  std::uint64_t varying = 0;  ///< those of BURIN_INPUT_RADIUS and BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME
                              ///< that vary along the stroke and must be stored per node
  const ParamDynamics* dynamics = nullptr;  ///< dynamics of strength and parameters; must outlive the nodes
};

/// The distances from a stroke's ends, for a brush that reads them.
struct StrokeEnds {
  const EndDistances* distances = nullptr;  ///< null: the brush does not read them
  /// The t up to which the distances of nodes near the begin may be others than at the last event.
  double others_up_to = -std::numeric_limits<double>::infinity();
};

/// The values that differ from node to node while a stroke grows: half width, pen, dynamics and distance from
/// the ends.
class StrokeNodes {
 public:
  /// The chart must be empty and outlive the object.
  StrokeNodes(const LiveChart& chart, const ReadInputs& reads)
      : chart_(&chart), reads_(reads), dynamics_(reads.dynamics), zone_(reads.radius / 8) {}

  /// Applies the last event of the chart, which is of this curve. A node is stale if it is new, if any bit of
  /// its inputs differs, or if its t is at least `end_zone`, where the brush may depend on the stroke's
  /// length. Up to the arc length `same_pen_up_to` the pen is as before.
  StrokeChanges follow(const SurfaceCurve& curve, double end_zone,
                       double same_pen_up_to = -std::numeric_limits<double>::infinity(),
                       const StrokeEnds& ends = {});

  /// The nodes of the end zone alone.
  StrokeChanges in_zone(double end_zone);

  const LiveChart& live() const { return *chart_; }
  const Chart& chart() const { return chart_->nodes(); }

  /// The half width, object units, and the pen at the node's t, by slot; empty if the brush does not read
  /// them.
  const std::vector<float>& half_width() const { return half_width_; }
  const std::vector<NodePen>& pen() const { return pen_; }
  const NodeDynamics& dynamics() const { return dynamics_; }

  /// The distance from the stroke's ends, object units, by slot; empty if the brush does not read it.
  const std::vector<float>& end_distance() const { return end_distance_; }

 private:
  void collect(double same_pen_up_to, double end_zone, const StrokeEnds& ends);
  void collect_ends(double end_zone, double others_up_to);
  void ask(Index slot);
  void compare_pens(const SurfaceCurve& curve);
  void compare_end_distances(const EndDistances& ends);
  void add_stale(Index slot);
  void add_vertex(Index slot);
  void add_other_sheets();
  template <class Use>
  void for_each_in_zone(double end_zone, double up_to, const Use& use);
  void add_zone(double end_zone, double up_to);
  double t_of(Index slot) const;
  StrokeChanges finished();

  const LiveChart* chart_;
  ReadInputs reads_;
  std::vector<float> half_width_;
  std::vector<NodePen> pen_;
  NodeDynamics dynamics_;

  std::vector<float> end_distance_;

  RisingThreshold zone_;
  StrokeChanges changes_;
  bool altered_listed_ = false;  ///< changes_ has the vertices that the chart's last event altered
  std::uint32_t event_ = 0;
  std::vector<std::uint32_t> stale_in_, vertex_in_;  ///< [slot], [local index]: event that added it last
  std::vector<Index> asked_;                         ///< slots whose values may differ, each once
  std::vector<std::uint32_t> asked_in_;              ///< [slot] event that asked for it last
  std::vector<std::uint8_t> differs_;                ///< [i of asked_]
};

/// The pen inputs that a recording with these fields provides.
std::uint64_t pen_inputs_present(const PenFields& fields);

}  // namespace burin
