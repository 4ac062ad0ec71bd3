// Interpolates the coordinates of charts at points of a surface. Of the combinations of nodes at a triangle's
// corners, the topmost one whose coordinates are close enough for neighbours is used. Costs O(1) per point
// where vertices have one node, and O(s^3) at most where they have s.
#include "pictures/checkerboard.h"

#include <burin/chart/path/closed_length.h>

#include <algorithm>
#include <cmath>

#include "pictures/render.h"

namespace burin {
namespace {

constexpr double squares_per_radius = 4;

/// The greatest differences of t and d, in edges, between neighbours on one sheet: d changes by at most the
/// distance, t by the distance over the stretch.
constexpr double edges_in_t = 4, edges_in_d = 1.25;

double longest_edge(const Surface& surface, const SurfacePoint& point) {
  const auto place = [&](int corner) {
    return surface.positions[point.corners[static_cast<std::size_t>(corner)]];
  };
  return std::max({(place(1) - place(0)).norm(), (place(2) - place(1)).norm(), (place(0) - place(2)).norm()});
}

}  // namespace

Vec3f checker_colour(double t, double d) {
  const bool odd = (static_cast<long>(std::floor(t)) + static_cast<long>(std::floor(d))) % 2 != 0;
  if (d > 0) return odd ? Vec3f(0.80f, 0.22f, 0.05f) : Vec3f(0.90f, 0.72f, 0.42f);
  return odd ? Vec3f(0.05f, 0.20f, 0.55f) : Vec3f(0.50f, 0.70f, 0.85f);
}

Checkerboard::Checkerboard(const Surface& surface)
    : surface_(&surface), first_(surface.positions.size(), no_index) {}

void Checkerboard::add(const Chart& chart, double radius) {
  const double scale = squares_per_radius / radius;
  const bool around = chart.closed && chart.length > 0;
  const double pairs = std::max(1., std::round(chart.length * scale / 2));
  const auto number = static_cast<std::uint32_t>(scales_.size());
  scales_.push_back({around ? 2 * pairs / chart.length : scale, scale, around ? chart.length : 0});
  for (std::size_t i = 0; i < chart.size(); ++i) {
    Index& first = first_[chart.vertex[i]];
    nodes_.push_back({chart.t[i], chart.d[i], number, first});
    first = static_cast<Index>(nodes_.size() - 1);
  }
}

Vec3f Checkerboard::operator()(const SurfacePoint& point) const {
  SheetTriangle sheet;
  const auto& weights = point.weights;
  if (!find_sheet(point, sheet)) {
    // At a rim, or where two sheets meet inside the triangle, coordinates cannot be interpolated.
    const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
    const Node* node = top(point.corners[static_cast<std::size_t>(nearest)]);
    return node ? colour(*node, node->t, static_cast<double>(node->d)) : clay(point);
  }
  double t = 0, d = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto weight = static_cast<double>(weights[corner]);
    t += weight * sheet.t[corner];
    d += weight * static_cast<double>(sheet.corners[corner]->d);
  }
  return colour(*sheet.corners[0], t, d);
}

/// Finds the topmost sheet on which all corners of the point's triangle lie.
bool Checkerboard::find_sheet(const SurfacePoint& point, SheetTriangle& sheet) const {
  const double edge = longest_edge(*surface_, point);
  for (const Node* node = top(point.corners[0]); node; node = below(*node)) {
    sheet.corners[0] = node;
    sheet.t[0] = node->t;
    if (complete(point, edge, 1, sheet)) return true;
  }
  return false;
}

/// Finds the nodes of the corners from this one on. Returns whether all were found.
bool Checkerboard::complete(const SurfacePoint& point, double edge, int corner, SheetTriangle& sheet) const {
  if (corner == 3) return true;
  const Node& first = *sheet.corners[0];
  const double length = scales_[first.chart].length;
  const Node* node = top(point.corners[static_cast<std::size_t>(corner)]);
  for (; node; node = below(*node)) {
    sheet.corners[corner] = node;
    sheet.t[corner] = t_nearest_to(first.t, node->t, length);
    if (on_sheet_of(sheet, corner, edge) && complete(point, edge, corner + 1, sheet)) return true;
  }
  return false;
}

bool Checkerboard::on_sheet_of(const SheetTriangle& sheet, int corner, double edge) const {
  const Node& node = *sheet.corners[corner];
  for (int other = 0; other < corner; ++other) {
    const Node& before = *sheet.corners[other];
    if (node.chart != before.chart || std::abs(sheet.t[corner] - sheet.t[other]) > edges_in_t * edge ||
        std::abs(static_cast<double>(node.d) - static_cast<double>(before.d)) > edges_in_d * edge)
      return false;
  }
  return true;
}

Vec3f Checkerboard::colour(const Node& node, double t, double d) const {
  const Scale& scale = scales_[node.chart];
  return checker_colour(t * scale.squares_t, d * scale.squares_d);
}

}  // namespace burin
