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

/// A point of a surface with its chart coordinates, interpolated linearly from the chart's nodes at the
/// corners of its triangle.
struct ChartPoint {
  SurfacePoint at;
  std::array<Index, 3> nodes{};  ///< nodes of the chart at at.corners; no_index at weights of 0 (at() only)
  std::uint32_t sheet = 0;       ///< sheet of the node with the largest weight
  double t = 0;                  ///< object units; in [0, length) on a closed stroke
  double d = 0;                  ///< object units
  Vec3f e1 = Vec3f::Zero();      ///< unit tangent along the stroke
  Vec3f normal = Vec3f::Zero();  ///< unit, outward; the base surface's where the stroke runs on it
  float stretch = 1;             ///< J = |dP/dt|

  Vec3f e2() const { return normal.cross(e1); }  ///< unit tangent to the left of the stroke, where d grows
};

/// Maps chart coordinates (t, d) to points of the surface, and points of the surface to chart coordinates.
/// The map is piecewise linear over the surface's triangles whose corners have nodes of one visit; its error
/// is O(edge^2). Several points have the same (t, d) where the stroke overlaps itself, and a few where
/// coordinates fold. No point is found
/// - in a bend tighter than the radius, for (t, d) beyond the line where the stroke's visits meet,
/// - in triangles whose image in the (t, d) plane is degenerate,
/// - at the chart's border (a butt cap, for example), in triangles of which a corner has no node.
///
/// Construction takes O(n log n) time and O(n) memory for n nodes. A query tests the triangles of one cell of
/// a grid, or of two on a closed stroke. Surface and chart must outlive the object and must not change. Const
/// functions may be called from several threads at once.
class ChartLookup {
 public:
  /// Throws ContractError when the chart names a vertex that the surface does not have.
  ChartLookup(const Surface& surface, const Chart& chart);

  /// Returns the point with the coordinates (t, d), object units; on a closed stroke t counts modulo the
  /// length. With `sheet`, the point's triangle must have at least one corner on this sheet. Among several
  /// points those win in whose triangle (t, d) is not mirrored, then the lowest triangle, then the lowest
  /// nodes. Returns nothing outside the chart and for values that are not finite. Throws ContractError on a
  /// point set, which has no triangles that cover it exactly once.
  std::optional<ChartPoint> find(double t, double d, std::optional<std::uint32_t> sheet = {}) const;

  /// Returns the coordinates of a point of the surface, one entry for each visit of the stroke that has nodes
  /// at all corners with a weight above 0, in the order of t. Point sets are supported.
  std::vector<ChartPoint> at(const SurfacePoint& point) const;

  /// Returns the orthogonal vector field (e1, e2) of the stroke at a point of the surface [Schmidt 2013,
  /// figure 7]: the entry of at() with the smallest |d|, then with the lowest t. Returns nothing outside the
  /// chart.
  std::optional<ChartPoint> field(const SurfacePoint& point) const;

 private:
  ChartPoint place(const SurfacePoint& at, const std::array<Index, 3>& nodes) const;

  const Surface* surface_;
  const Chart* chart_;
  std::vector<ChartTriangle> triangles_;
  BoxGrid grid_;  ///< bounding boxes of triangles_ in the (t, d) plane
};

}  // namespace burin
