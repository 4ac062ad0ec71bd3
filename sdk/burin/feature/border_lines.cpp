// The open border of a surface as line segments in the image of a chart.
#include <burin/chart/path/closed_length.h>
#include <burin/feature/border_lines.h>
#include <burin/feature/smoothed_image.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

/// The only triangle at the edge between two vertices; no_index if there are more.
Index only_triangle(const Surface& surface, Index a, Index b) {
  Index only = no_index;
  for (const Index triangle : surface.incident[a]) {
    if (std::ranges::find(surface.triangles[triangle], b) == surface.triangles[triangle].end()) continue;
    if (only != no_index) return no_index;
    only = triangle;
  }
  return only;
}

/// The place of the node of a vertex that is nearest to a place and at most `farthest` pixels away.
std::optional<Vec2d> nearest_node(const Chart& chart, const ChartGrid& grid, Index vertex, const Vec2d& near,
                                  double farthest) {
  const auto [begin, end] = std::ranges::equal_range(chart.vertex, vertex);
  std::optional<Vec2d> best;
  for (auto node = static_cast<std::size_t>(begin - chart.vertex.begin());
       node < static_cast<std::size_t>(end - chart.vertex.begin()); ++node) {
    const double t =
        chart.closed ? t_nearest_to(grid.t(near.x()), chart.t[node], chart.length) : chart.t[node];
    const Vec2d place(grid.x(t), grid.y(static_cast<double>(chart.d[node])));
    const double distance = (place - near).norm();
    if (distance > farthest) continue;
    best = place;
    farthest = distance;
  }
  return best;
}

/// The point of an edge at this share of it.
SurfacePoint point_on(const Surface& surface, const BorderEdge& edge, float share) {
  SurfacePoint point{edge.triangle, surface.triangles[edge.triangle], {}, Vec3f::Zero()};
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.corners[i] == edge.vertices[0]) point.weights[i] = 1 - share;
    if (point.corners[i] == edge.vertices[1]) point.weights[i] = share;
    point.position += point.weights[i] * surface.positions[point.corners[i]];
  }
  return point;
}

}  // namespace

std::vector<BorderEdge> border_edges(const Surface& surface, const Chart& chart, const ChartGrid& grid) {
  std::vector<BorderEdge> edges;
  constexpr double edges_apart = 2;
  for (std::size_t node = 0; node < chart.size(); ++node) {
    const Index a = chart.vertex[node];
    const Vec2d from(grid.x(chart.t[node]), grid.y(static_cast<double>(chart.d[node])));
    for (const Index b : surface.neighbours[a]) {
      if (b < a) continue;
      const Index triangle = only_triangle(surface, a, b);
      if (triangle == no_index) continue;
      const auto length = static_cast<double>((surface.positions[b] - surface.positions[a]).norm());
      const double farthest = edges_apart * length / std::min(grid.step_t, grid.step_d);
      if (const auto to = nearest_node(chart, grid, b, from, farthest))
        edges.push_back({triangle, {a, b}, {from, *to}});
    }
  }
  return edges;
}

LevelImage border_image(const std::vector<BorderEdge>& edges, const ChartGrid& grid, double deviation) {
  LevelImage image{grid, std::vector<float>(grid.size())};
  for (const BorderEdge& edge : edges) {
    const Vec2d way = edge.places[1] - edge.places[0];
    const int pieces = 1 + static_cast<int>(2 * way.norm());
    for (int i = 0; i < pieces; ++i) {
      const Vec2d place = edge.places[0] + (i + 0.5) / pieces * way;
      splat(grid, image.values, place.cast<float>(), static_cast<float>(way.norm() / pieces));
    }
  }
  blur(grid, image.values, {deviation, deviation});
  const double peak = 1 / (std::sqrt(2 * std::numbers::pi) * deviation);
  for (float& value : image.values) value /= static_cast<float>(peak);
  return image;
}

std::optional<BorderPoint> border_at(const Surface& surface, const std::vector<BorderEdge>& edges,
                                     double column, double row) {
  std::optional<BorderPoint> best;
  for (const BorderEdge& edge : edges) {
    const auto& [from, to] = edge.places;
    if ((from.x() - column) * (to.x() - column) > 0 || from.x() == to.x()) continue;
    const double share = (column - from.x()) / (to.x() - from.x());
    const double at = from.y() + share * (to.y() - from.y());
    if (best && std::abs(at - row) >= std::abs(best->row - row)) continue;
    best = {at, point_on(surface, edge, static_cast<float>(share))};
  }
  return best;
}

}  // namespace burin
