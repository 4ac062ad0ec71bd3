#include "checkerboard.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render.h"

namespace burin {

constexpr double squares_a_radius = 4;

Vec3f checker_colour(float t, float d) {
  const bool odd = (static_cast<long>(std::floor(t)) + static_cast<long>(std::floor(d))) % 2 != 0;
  if (d > 0) return odd ? Vec3f(0.80f, 0.22f, 0.05f) : Vec3f(0.90f, 0.72f, 0.42f);
  return odd ? Vec3f(0.05f, 0.20f, 0.55f) : Vec3f(0.50f, 0.70f, 0.85f);
}

Checkerboard::Checkerboard(const Surface& surface) : nodes_(surface.positions.size()) {}

void Checkerboard::add(const Chart& chart, double radius) {
  ++charts_;
  const double scale = squares_a_radius / radius;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    nodes_[chart.vertex[i]] = {static_cast<float>(chart.t[i] * scale), static_cast<float>(chart.d[i] * scale),
                               charts_};
  }
}

Vec3f Checkerboard::operator()(const SurfacePoint& point) const {
  const auto& [a, b, c] = point.corners;
  const std::array<Node, 3> corners = {nodes_[a], nodes_[b], nodes_[c]};
  const std::array<float, 3>& weights = point.weights;
  const auto [t_min, t_max] = std::minmax({corners[0].t, corners[1].t, corners[2].t});
  const bool one_chart = corners[0].chart == corners[1].chart && corners[0].chart == corners[2].chart;
  // Where two charts, or two passes of one stroke, meet inside a triangle nothing lies between them.
  if (!one_chart || t_max - t_min > squares_a_radius) {
    const Node& nearest =
        corners[static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin())];
    return nearest.chart == 0 ? clay(point) : checker_colour(nearest.t, nearest.d);
  }
  if (corners[0].chart == 0) return clay(point);
  float t = 0, d = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    t += weights[corner] * corners[corner].t;
    d += weights[corner] * corners[corner].d;
  }
  return checker_colour(t, d);
}

}  // namespace burin
