#pragma once
#include <burin/base/rising_threshold.h>
#include <burin/chart/chart_options.h>
#include <burin/chart/joins/leg_charts.h>
#include <burin/chart/joins/vertex_join.h>
#include <burin/chart/live_chart.h>
#include <burin/surface/base_surface/base_surface.h>

#include <vector>

namespace burin {

/// Joins the growing charts of a stroke's legs at the vertices of a surface: the choice between legs, and
/// coordinates that joins change, are those of the vertex. Where the legs were charted on a base surface, a
/// vertex first gets the coordinates of its foot point there, by one second-order step from each node of its
/// cluster (CoordinatePatch). An event recomputes only the vertices of changed nodes and those that changed
/// joins influence. Uses all threads; the result does not depend on their number.
class LegTransfer {
 public:
  /// `base` is null for charts on the vertices themselves. Base and surface must outlive the object. The
  /// slots of the vertices' chart below `first_slot` are not used; the first update() removes their nodes.
  LegTransfer(BaseSurface* base, const Surface& surface, double radius, Index first_slot)
      : base_(base), surface_(&surface), unused_(first_slot), slots_(first_slot), stale_(nearness * radius) {}

  /// Applies the last update of the charts, which are those of this curve, to `vertices`. `curve` lies on the
  /// base surface, if there is one; the options are those of the stroke. The charts must be the same at each
  /// call.
  void update(const LegCharts& charts, const SurfaceCurve& curve, const ChartOptions& options,
              LiveChart& vertices);

 private:
  /// How far joins that change reach back, in radii, before all nodes are looked at.
  static constexpr double nearness = 16;

  /// The slots of the vertices' chart that belong to one node: `sheets` for each vertex of its cluster.
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
  /// A vertex, its normal and its nodes.
  struct OfVertex {
    Index vertex;
    Vec3f normal;
    std::vector<LegNode> nodes;
  };

  std::vector<Index> find_stale(const LegCharts& charts, double same_below);
  void make_room(const LegCharts& charts, Index local, LiveChart& vertices);
  std::vector<OfVertex> cluster(const LegCharts& charts, Index local) const;
  std::vector<Result> joined(const LegCharts& charts, Index local, const VertexJoin& join) const;

  BaseSurface* base_;
  const Surface* surface_;
  std::vector<Range> ranges_;   ///< [number of the vertex of the charts]
  std::vector<double> last_t_;  ///< [number of the vertex of the charts] the greatest t of its nodes
  Index unused_;                ///< slots that hold nodes of another transfer
  Index slots_;                 ///< number of slots in use
  RisingThreshold stale_;       ///< vertices of the charts by last_t_
};

}  // namespace burin
