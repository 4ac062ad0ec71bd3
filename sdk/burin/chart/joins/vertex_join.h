#pragma once
#include <burin/chart/chart_options.h>
#include <burin/chart/joins/leg_node.h>
#include <burin/chart/joins/stroke_legs.h>
#include <burin/stroke/curve/surface_curve.h>

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Joins the nodes that the legs of a stroke and the bends between them have at one vertex. Joins choose
/// between the nodes of legs and change their coordinates. A vertex without a chosen node takes that of a
/// bend, or else the nearest of its legs. So each vertex within the half width of any part keeps a node. With
/// Join::overlap legs and bends keep all nodes that lie beside them. Several threads may use one object.
class VertexJoin {
 public:
  /// Legs and curve must outlive the object.
  VertexJoin(const StrokeLegs& legs, const SurfaceCurve& curve, const ChartOptions& options);

  /// Replaces the nodes of one vertex by those of the joined stroke, in the order of t. `normal` is the unit
  /// normal at the vertex. On a closed stroke t is reduced to [0, length).
  void join(std::vector<LegNode>& nodes, const Vec3f& normal) const;

 private:
  using Nodes = std::span<LegNode>;
  void measure(LegNode& node) const;
  bool is_past_joint(const LegNode& node) const;
  bool is_cut_off(const LegNode& node) const;
  bool is_inside(const LegNode& node) const;
  std::optional<LegNode> nearest_of(Nodes of_legs, const Vec3f& normal) const;
  void smooth(Nodes of_legs, Nodes of_bends, const Vec3f& normal) const;
  void smooth_corner(LegNode& node, const LegEnd& end, Nodes of_bends, const Vec3f& normal) const;
  void smooth_bend(LegNode& node, const SpreadBend& spread) const;
  void fill_from_bends(Nodes of_legs, Nodes of_bends, const Vec3f& normal) const;

  const StrokeLegs& legs_;
  const SurfaceCurve& curve_;
  ChartOptions options_;
  bool uniform_;  ///< the stroke's width is 1 everywhere
};

}  // namespace burin
