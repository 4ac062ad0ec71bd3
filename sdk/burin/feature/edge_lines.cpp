// Lines of edges of a surface as line segments in the image of a chart.
#include <burin/chart/path/closed_length.h>
#include <burin/feature/edge_lines.h>
#include <burin/feature/smoothed_image.h>
#include <burin/math/elementary.h>
#include <burin/surface/geometry/area_vector.h>
#include <burin/surface/geometry/triangle_shape.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace burin {
namespace {

/// The triangles at the edge between two vertices.
std::vector<Index> triangles_at(const Surface& surface, Index a, Index b) {
  std::vector<Index> triangles;
  for (const Index triangle : surface.incident[a])
    if (std::ranges::find(surface.triangles[triangle], b) != surface.triangles[triangle].end())
      triangles.push_back(triangle);
  return triangles;
}

/// Whether b follows a in the order of a triangle's vertices.
bool leads(const Surface& surface, Index triangle, Index a, Index b) {
  const Triangle& corners = surface.triangles[triangle];
  return corners[(corner_of(corners, a) + 1) % 3] == b;
}

/// Whether the edge from a to b, which these triangles have, belongs to the lines of a feature.
bool belongs(const Surface& surface, Index a, Index b, std::span<const Index> triangles,
             const Feature& feature) {
  if (feature.kind == FeatureKind::border) return triangles.size() == 1;
  if (std::ranges::binary_search(feature.creases, std::array{std::min(a, b), std::max(a, b)})) return true;
  if (triangles.size() != 2) return false;
  const Vec3d one = area_vector(surface.positions, surface.triangles[triangles[0]]);
  // Neighbours need not have the same orientation.
  const bool opposite = leads(surface, triangles[0], a, b) == leads(surface, triangles[1], a, b);
  const Vec3d other = (opposite ? -1 : 1) * area_vector(surface.positions, surface.triangles[triangles[1]]);
  const double angle = math::atan2(one.cross(other).norm(), one.dot(other));
  return angle >= feature.least_angle * std::numbers::pi / 180;
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
SurfacePoint point_on(const Surface& surface, const LineEdge& edge, float share) {
  SurfacePoint point{edge.triangle, surface.triangles[edge.triangle], {}, Vec3f::Zero()};
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.corners[i] == edge.vertices[0]) point.weights[i] = 1 - share;
    if (point.corners[i] == edge.vertices[1]) point.weights[i] = share;
    point.position += point.weights[i] * surface.positions[point.corners[i]];
  }
  return point;
}

/// Adds an edge, on closed strokes also where the columns beyond an end repeat it.
void add_edge(std::vector<LineEdge>& edges, const ChartGrid& grid, LineEdge edge) {
  edges.push_back(edge);
  if (!grid.closed) return;
  const double turn = edge.places[0].x() < 0.5 * grid.columns ? grid.inner_columns() : -grid.inner_columns();
  for (Vec2d& place : edge.places) place.x() += turn;
  const auto [least, most] = std::minmax(edge.places[0].x(), edge.places[1].x());
  if (most > 0 && least < grid.columns - 1) edges.push_back(edge);
}

}  // namespace

std::vector<LineEdge> line_edges(const Surface& surface, const Chart& chart, const ChartGrid& grid,
                                 const Feature& feature) {
  std::vector<LineEdge> edges;
  constexpr double edges_apart = 2;
  for (std::size_t node = 0; node < chart.size(); ++node) {
    const Index a = chart.vertex[node];
    const Vec2d from(grid.x(chart.t[node]), grid.y(static_cast<double>(chart.d[node])));
    for (const Index b : surface.neighbours[a]) {
      if (b < a) continue;
      const std::vector<Index> triangles = triangles_at(surface, a, b);
      if (!belongs(surface, a, b, triangles, feature)) continue;
      const auto length = static_cast<double>((surface.positions[b] - surface.positions[a]).norm());
      const double farthest = edges_apart * length / std::min(grid.step_t, grid.step_d);
      if (const auto to = nearest_node(chart, grid, b, from, farthest))
        add_edge(edges, grid, {triangles[0], {a, b}, {from, *to}});
    }
  }
  return edges;
}

LevelImage nearness_image(const std::vector<LineEdge>& edges, const ChartGrid& grid, double deviation) {
  LevelImage image{grid, std::vector<float>(grid.size())};
  for (const LineEdge& edge : edges) {
    const Vec2d way = edge.places[1] - edge.places[0];
    const int pieces = 1 + static_cast<int>(2 * way.norm());
    for (int i = 0; i < pieces; ++i) {
      const Vec2d place = edge.places[0] + (i + 0.5) / pieces * way;
      pixel_shares(grid, place.cast<float>()).add_to(image.values, static_cast<float>(way.norm() / pieces));
    }
  }
  blur(grid, image.values, {deviation, deviation});
  const double peak = 1 / (std::sqrt(2 * std::numbers::pi) * deviation);
  // Where lines meet, paths must not linger.
  for (float& value : image.values) value = std::min(value / static_cast<float>(peak), 1.F);
  return image;
}

std::optional<LinePoint> crossing_at(const Surface& surface, const std::vector<LineEdge>& edges,
                                     double column, double row) {
  std::optional<LinePoint> best;
  for (const LineEdge& edge : edges) {
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
