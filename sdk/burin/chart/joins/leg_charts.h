#pragma once
#include <burin/chart/front/front.h>
#include <burin/chart/joins/leg_node.h>
#include <burin/chart/joins/stroke_legs.h>
#include <burin/chart/vertex_nodes.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// The charts of the legs of a stroke and of the bends between them, before they are joined. Each leg is
/// charted as a stroke of its own, which continues straight beyond its ends where a join needs that; bends
/// have round ends. So every vertex within the half width of the stroke has a node.
class LegCharts {
 public:
  /// The ground's surface must outlive the object. `options` are those of the stroke; the half width of the
  /// charts at width 1, `charted_radius`, object units, may be greater than the stroke's.
  LegCharts(const ChartGround& ground, const ChartOptions& options, double charted_radius)
      : ground_(ground),
        charted_radius_(charted_radius),
        order_(options.order),
        stroke_(options, charted_radius),
        local_(ground.vertex_count()) {}

  /// Charts the legs of this curve, whose first `unchanged` points are those of the last call. `front` does
  /// the work and must not be used for anything else between the first and the last call. Only what changed
  /// is charted again.
  void update(const SurfaceCurve& curve, std::size_t unchanged, Front& front);

  const StrokeLegs& stroke() const { return stroke_; }

  /// The vertices that ever had nodes are numbered from 0 in the order of their appearance.
  Index local_count() const { return local_.size(); }
  Index vertex(Index local) const { return local_.vertex(local); }
  /// The nodes of such a vertex, in no particular order. On a closed stroke t is not reduced to [0, length).
  /// VertexJoin sets distances and half widths.
  std::span<const LegNode> nodes(Index local) const { return nodes_[local]; }

  /// The vertices whose nodes changed in the last update, each once, by their numbers.
  std::span<const Index> changed() const { return changed_; }

  /// Below this arc length joins have the same results as in the last update where nodes have not changed.
  double same_below() const { return same_below_; }

  /// The numbers of nodes settled and of queue entries pushed in the last update().
  std::uint64_t settled() const { return settled_; }
  std::uint64_t pushes() const { return pushes_; }

 private:
  /// A leg or a bend that was charted.
  struct Part {
    std::optional<Leg> leg;       ///< none: it has no chart
    std::vector<Index> vertices;  ///< numbers of the vertices at which it has had nodes
  };

  Part& part(Index number);
  void drop_parts(std::size_t legs, std::size_t cuts);
  void chart_leg(const SurfaceCurve& curve, Index leg, std::size_t unchanged, Front& front);
  void chart_bend(const SurfaceCurve& curve, Index cut);
  void clear_part(Index number);
  void follow(const Front& front, Index number, const Leg& now);
  void set(const LegNode& node, Index vertex);
  void remove(Index number, Index slot);
  void note_change(Index local);

  ChartGround ground_;
  double charted_radius_;
  int order_;
  StrokeLegs stroke_;
  std::vector<Part> parts_;  ///< [number of the part]
  VertexNodes local_;
  std::vector<std::vector<LegNode>> nodes_;  ///< [number of the vertex]
  std::vector<Index> changed_;
  std::vector<std::uint8_t> has_changed_;  ///< [number of the vertex]
  std::optional<Front> bend_front_;        ///< charts bends; created for the first bend
  std::optional<Index> front_leg_;         ///< the leg whose chart the caller's front holds
  SurfaceCurve front_curve_;               ///< the part of the curve that is this leg; empty: it is whole
  std::vector<Index> at_slot_;  ///< [slot of the caller's front] number of the vertex whose node it holds
  double same_below_ = 0;
  std::uint64_t settled_ = 0, pushes_ = 0;
};

}  // namespace burin
