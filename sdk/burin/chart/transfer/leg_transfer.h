#pragma once
#include <burin/chart/chart_options.h>
#include <burin/chart/ground_chart_builder.h>
#include <burin/chart/joins/vertex_join.h>
#include <burin/chart/live_chart.h>
#include <burin/chart/vertex_nodes.h>
#include <burin/surface/base_surface/base_surface.h>

#include <span>
#include <vector>

namespace burin {

/// Interpolates the growing charts of a stroke's legs on a base surface to the vertices of the surface, and
/// joins them there: the choice between legs, and coordinates that joins change, are those of the vertex. A
/// vertex gets the coordinates of its foot point on the base surface, by one second-order step from each node
/// of its cluster (CoordinatePatch). An event recomputes only the clusters of changed nodes and those that
/// changed joins influence. Uses all threads; the result does not depend on their number.
class LegTransfer {
 public:
  /// Base and surface must outlive the object. The slots of the vertices' chart below `first_slot` are not
  /// used; the first update() removes their nodes.
  LegTransfer(BaseSurface& base, const Surface& surface, Index first_slot)
      : base_(&base),
        surface_(&surface),
        local_(base.node_count()),
        unused_(first_slot),
        slots_(first_slot) {}

  /// Applies the legs of the last event, which are those of this curve, to `vertices`. `curve` lies on the
  /// base surface; the options are those of the stroke.
  void update(GroundChartBuilder::Legs legs, const SurfaceCurve& curve, const ChartOptions& options,
              LiveChart& vertices);

 private:
  using Nodes = std::span<const LegNode>;

  /// The slots of the vertices' chart that belong to one base node: `sheets` for each vertex of its cluster.
  struct Range {
    Index begin = 0, vertices = 0, sheets = 0;
    Index size() const { return vertices * sheets; }
  };
  struct Result {
    Index slot, vertex;
    ChartFrame frame;
    Vec3f normal;
    bool filled;  ///< otherwise the slot becomes vacant
  };

  std::vector<Nodes> find_stale(Nodes before, Nodes now, double same_below, LiveChart& vertices);
  void make_room(Nodes of_node, LiveChart& vertices);
  void vacate(const Range& range, LiveChart& vertices);
  std::vector<Result> joined(Nodes of_node, const VertexJoin& join) const;

  BaseSurface* base_;
  const Surface* surface_;
  VertexNodes local_;           ///< the base nodes that ever had nodes, by local index
  std::vector<Range> ranges_;   ///< [local index]
  std::vector<LegNode> nodes_;  ///< of the last event
  Index unused_;                ///< slots that hold nodes of another transfer
  Index slots_;                 ///< number of slots in use
};

}  // namespace burin
