#pragma once
#include <burin/chart/box_grid.h>
#include <burin/chart/chart.h>
#include <burin/chart/chart_triangles.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// A place of a surface in a chart, with what is known at the chart's nodes interpolated to it.
struct ChartPlace {
  SurfacePoint at;
  std::array<Index, 3> nodes{};  ///< of the chart, at at.corners; of at(), no_index where the weight is 0
  std::uint32_t sheet = 0;       ///< of the node of the largest weight
  double t = 0;                  ///< object units, in [0, length) of a closed stroke
  double d = 0;                  ///< object units
  Vec3f e1 = Vec3f::Zero();      ///< unit tangent along the stroke
  Vec3f normal = Vec3f::Zero();  ///< unit, outward; of the base surface where the stroke runs on it
  float stretch = 1;             ///< J = |dP/dt|

  Vec3f e2() const { return normal.cross(e1); }  ///< to the left of the stroke, where d grows
};

/// Goes from chart coordinates back to the surface. The triangles of the surface whose corners have nodes
/// that belong together cover a part of the (t, d) plane, piecewise linear: a place lies O(edge^2) off. They
/// hold (t, d) more than once where the stroke overlaps itself and a little where coordinates fold. In a bend
/// tighter than the radius the runs' triangles end where the runs meet, short of an edge, and (t, d) beyond
/// have no place. Nor have they in triangles that the chart makes degenerate, and along its border, butt caps
/// for one, in triangles of which it does not hold all corners.
///
/// Built in time and memory in proportion to the chart, but for a logarithm; a question looks at the
/// triangles of one cell of a grid, on a closed stroke two. Surface and chart must outlive it and stay as
/// they are. Const functions: any thread, concurrent.
class ChartLookup {
 public:
  /// Throws ContractError when the chart names a vertex that the surface has not.
  ChartLookup(const Surface& surface, const Chart& chart);

  /// The place of (t, d), object units; of a closed stroke any t modulo its length. With `sheet` one whose
  /// triangle has at least one corner on this sheet, all corners count. Of several places one that the chart
  /// does not mirror, then that of the lowest triangle, then nodes. Nothing outside the chart and for numbers
  /// that are not finite. Throws ContractError on a point set: links make no triangles that cover it once.
  std::optional<ChartPlace> find(double t, double d, std::optional<std::uint32_t> sheet = {}) const;

  /// Where a point of the surface is in the chart, by t: a place for each visit of the stroke that has nodes
  /// at all corners whose weight is above 0. On point sets too.
  std::vector<ChartPlace> at(const SurfacePoint& point) const;

  /// The orthogonal vector field (e1, e2) that the stroke spreads over the surface [Schmidt 2013, figure 7]:
  /// of at(), the place nearest to the stroke, then of the lowest t. Nothing outside the chart.
  std::optional<ChartPlace> field(const SurfacePoint& point) const;

 private:
  ChartPlace place(const SurfacePoint& at, const std::array<Index, 3>& nodes) const;

  const Surface* surface_;
  const Chart* chart_;
  std::vector<ChartTriangle> triangles_;
  BoxGrid grid_;  ///< of triangles_ in the plane of t and d
};

}  // namespace burin
