// Locates points in the (t, d) plane: a uniform grid lists the bounding boxes of the chart's triangles, and
// barycentric coordinates decide. The header has the costs.
#include <burin/base/error.h>
#include <burin/chart/chart_lookup.h>
#include <burin/chart/path/closed_length.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using ChartCorners = std::array<Vec2d, 3>;  ///< (t, d) of a triangle's nodes

ChartCorners corners_of(const Chart& chart, const ChartTriangle& triangle) {
  ChartCorners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = Vec2d(triangle.t[i], static_cast<double>(chart.d[triangle.nodes[i]]));
  }
  return corners;
}

BoxGrid grid_of(const Chart& chart, const std::vector<ChartTriangle>& triangles) {
  std::vector<Eigen::AlignedBox2d> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const Vec2d& corner : corners_of(chart, triangles[i])) boxes[i].extend(corner);
  }
  return BoxGrid(boxes);
}

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A point in a triangle of the lookup, in barycentric coordinates.
struct Hit {
  Index triangle = no_index;
  bool mirrored = true;
  Vec3d weights = Vec3d::Zero();
};

/// Returns nothing when the point is not in the triangle. Points on its edges are inside within a tolerance,
/// so that rounding loses no point between two triangles.
std::optional<Hit> hit(const ChartCorners& corners, const Vec2d& place, Index triangle) {
  constexpr double edge_width = 1e-9;  // in shares of the triangle's height
  const auto& [a, b, c] = corners;
  const double area = cross(b - a, c - a);
  if (area == 0) return std::nullopt;
  const Vec3d shares =
      Vec3d(cross(b - place, c - place), cross(c - place, a - place), cross(a - place, b - place)) / area;
  if (!(shares.minCoeff() >= -edge_width)) return std::nullopt;
  const Vec3d weights = shares.cwiseMax(0);
  return Hit{triangle, area < 0, weights / weights.sum()};
}

SurfacePoint point_in(const Surface& surface, Index triangle, const Vec3d& weights) {
  SurfacePoint point{triangle, surface.triangles[triangle], {}, Vec3f::Zero()};
  Vec3d position = Vec3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = weights[static_cast<Eigen::Index>(i)];
    point.weights[i] = static_cast<float>(weight);
    position += weight * surface.positions[point.corners[i]].cast<double>();
  }
  point.position = position.cast<float>();
  return point;
}

/// Reduces t to [0, length) on a closed stroke.
double wrapped(const Chart& chart, double t) { return chart.closed ? wrapped_t(t, chart.length) : t; }

}  // namespace

ChartLookup::ChartLookup(const Surface& surface, const Chart& chart) : surface_(&surface), chart_(&chart) {
  if (chart.size() > 0 && chart.vertex.back() >= surface.vertex_count())
    throw ContractError("the chart to look up is of another surface");
  triangles_ = chart_triangles(surface, chart);
  grid_ = grid_of(chart, triangles_);
}

std::optional<ChartPoint> ChartLookup::find(double t, double d, std::optional<std::uint32_t> sheet) const {
  if (surface_->is_point_set()) throw ContractError("a point set has no triangles to find (t, d) in");
  if (!std::isfinite(t) || !std::isfinite(d)) return std::nullopt;
  const auto on_sheet = [&](Index node) { return !sheet || chart_->sheet[node] == *sheet; };
  Hit best;
  const auto look_at = [&](const Vec2d& place) {
    for (const Index i : grid_.around(place)) {
      const ChartTriangle& triangle = triangles_[i];
      const auto found = hit(corners_of(*chart_, triangle), place, i);
      if (!found || std::ranges::none_of(triangle.nodes, on_sheet)) continue;
      if (std::pair(found->mirrored, i) < std::pair(best.mirrored, best.triangle)) best = *found;
    }
  };
  const double from_begin = wrapped(*chart_, t);
  look_at({from_begin, d});
  // Triangles across the seam of a closed stroke reach beyond its length.
  if (chart_->closed) look_at({from_begin + chart_->length, d});
  if (best.triangle == no_index) return std::nullopt;
  const ChartTriangle& triangle = triangles_[best.triangle];
  return place(point_in(*surface_, triangle.triangle, best.weights), triangle.nodes);
}

std::vector<ChartPoint> ChartLookup::at(const SurfacePoint& point) const {
  std::array<Index, 3> corners = point.corners;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(point.weights[i] > 0)) corners[i] = no_index;
  }
  if (std::ranges::all_of(corners, [](Index corner) { return corner == no_index; })) return {};
  std::vector<ChartPoint> places;
  for (const auto& nodes : nodes_together(*surface_, *chart_, corners)) places.push_back(place(point, nodes));
  std::ranges::stable_sort(places, {}, &ChartPoint::t);
  return places;
}

std::optional<ChartPoint> ChartLookup::field(const SurfacePoint& point) const {
  const std::vector<ChartPoint> places = at(point);
  if (places.empty()) return std::nullopt;
  return *std::ranges::min_element(places, {}, [](const ChartPoint& place) { return std::abs(place.d); });
}

ChartPoint ChartLookup::place(const SurfacePoint& at, const std::array<Index, 3>& nodes) const {
  const auto heaviest = static_cast<std::size_t>(std::ranges::max_element(at.weights) - at.weights.begin());
  const Index main = nodes[heaviest];
  ChartPoint place{.at = at, .nodes = nodes, .sheet = chart_->sheet[main], .stretch = 0};
  Vec3f e1 = Vec3f::Zero(), normal = Vec3f::Zero();
  double beyond = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index node = nodes[i];
    if (node == no_index) continue;
    const float weight = at.weights[i];
    beyond += static_cast<double>(weight) * (t_beside(*chart_, chart_->t[main], node) - chart_->t[main]);
    place.d += static_cast<double>(weight) * static_cast<double>(chart_->d[node]);
    e1 += weight * chart_->e1[node];
    normal += weight * chart_->normal[node];
    place.stretch += weight * chart_->stretch[node];
  }
  place.t = wrapped(*chart_, chart_->t[main] + beyond);
  const float length = normal.norm();
  place.normal = length > 1e-6F ? Vec3f(normal / length) : chart_->normal[main];
  place.e1 = unit_tangent(e1, place.normal);
  return place;
}

}  // namespace burin
