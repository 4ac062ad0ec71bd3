#pragma once
#include <burin/chart/chart.h>
#include <burin/feature/chart_grid.h>
#include <burin/feature/feature.h>
#include <burin/feature/level_image.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <array>
#include <optional>
#include <vector>

namespace burin {

/// An edge of a line of the surface in the image of a chart.
struct LineEdge {
  Index triangle = no_index;  ///< one at the edge
  std::array<Index, 2> vertices{};
  std::array<Vec2d, 2> places{};  ///< of its vertices, pixels
};

/// The edges of the open border, or of creases, whose vertices have nodes of one visit in the chart.
std::vector<LineEdge> line_edges(const Surface& surface, const Chart& chart, const ChartGrid& grid,
                                 const Feature& feature);

/// How near a line is: 1 on a long straight one, falling by a Gaussian of this standard deviation (pixels);
/// nowhere more.
LevelImage nearness_image(const std::vector<LineEdge>& edges, const ChartGrid& grid, double deviation);

/// A point of a line.
struct LinePoint {
  double row = 0;  ///< pixels
  SurfacePoint at;
};

/// Where the lines cross a column, nearest to a row; nothing if they do not.
std::optional<LinePoint> crossing_at(const Surface& surface, const std::vector<LineEdge>& edges,
                                     double column, double row);

}  // namespace burin
