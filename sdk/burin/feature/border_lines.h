#pragma once
#include <burin/chart/chart.h>
#include <burin/feature/chart_grid.h>
#include <burin/feature/level_image.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <array>
#include <optional>
#include <vector>

namespace burin {

/// An edge of the surface's open border in the image of a chart.
struct BorderEdge {
  Index triangle = no_index;  ///< the only one at the edge
  std::array<Index, 2> vertices{};
  std::array<Vec2d, 2> places{};  ///< of its vertices, pixels
};

/// The edges of the open border whose vertices have nodes of one visit in the chart.
std::vector<BorderEdge> border_edges(const Surface& surface, const Chart& chart, const ChartGrid& grid);

/// How near the border is: 1 on a long straight one, falling by a Gaussian of this standard deviation
/// (pixels).
LevelImage border_image(const std::vector<BorderEdge>& edges, const ChartGrid& grid, double deviation);

/// A point of the border.
struct BorderPoint {
  double row = 0;  ///< pixels
  SurfacePoint at;
};

/// Where the border crosses a column, nearest to a row; nothing if it does not.
std::optional<BorderPoint> border_at(const Surface& surface, const std::vector<BorderEdge>& edges,
                                     double column, double row);

}  // namespace burin
