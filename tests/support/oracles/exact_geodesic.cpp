#include "exact_geodesic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "polyhedral_distance.h"
#include "region.h"

namespace burin::test {
namespace {

// These lengths are in radii.
constexpr double source_spacing = 1. / 20;
constexpr double search_width = 1. / 5;  ///< sources on either side of a node's t
constexpr double strip_width =
    9. / 20;  ///< the surface on either side of a source that its geodesics may cross

/// The distance of a node from one point of the stroke.
struct Reading {
  double t, distance;
};

/// Points of the curve that are at least the spacing apart.
std::vector<const CurvePoint*> spaced_points(const SurfaceCurve& curve, double spacing) {
  std::vector<const CurvePoint*> points;
  for (const CurvePoint& point : curve.points) {
    if (points.empty() || point.t >= points.back()->t + spacing) points.push_back(&point);
  }
  return points;
}

/// The part of the chart's region around t in which a geodesic at right angles to the stroke stays.
Region strip_around(const Surface& surface, const Chart& chart, double t, double width) {
  std::vector<Index> triangles;
  for (std::size_t node = 0; node < chart.size(); ++node) {
    if (std::abs(chart.t[node] - t) > width) continue;
    const auto around = surface.incident[chart.vertex[node]];
    triangles.insert(triangles.end(), around.begin(), around.end());
  }
  return make_region(surface, std::move(triangles));
}

/// Fits a parabola to the squared distances of the nearest reading and its neighbours; returns its minimum.
std::optional<ExactNode> nearest_point(std::size_t node, double own_t, const std::vector<Reading>& readings) {
  const auto least = std::ranges::min_element(readings, {}, &Reading::distance);
  if (least == readings.end() || least == readings.begin() || least + 1 == readings.end())
    return std::nullopt;
  const Reading &a = *(least - 1), &b = *least, &c = *(least + 1);
  const auto squared = [](const Reading& reading) { return reading.distance * reading.distance; };
  const double before = (squared(b) - squared(a)) / (b.t - a.t);
  const double after = (squared(c) - squared(b)) / (c.t - b.t);
  const double curvature = (after - before) / (c.t - a.t);
  const double slope = before + curvature * (b.t - a.t);             // at b
  const double foot = curvature > 0 ? -slope / (2 * curvature) : 0;  // from b
  const auto at = [&](double s) { return std::sqrt(std::max(0., squared(b) + s * (slope + curvature * s))); };
  return ExactNode{node, at(foot), at(own_t - b.t), b.t + foot, curvature};
}

class Readings {
 public:
  Readings(const Chart& chart, std::span<const std::size_t> nodes, double radius)
      : chart_(chart), nodes_(nodes), radius_(radius), of_node_(nodes.size()) {}

  void take(const Surface& surface, const CurvePoint& source) {
    const auto reads = [&](std::size_t node) {
      return std::abs(chart_.t[node] - source.t) <= search_width * radius_;
    };
    if (std::ranges::none_of(nodes_, reads)) return;
    const Region strip = strip_around(surface, chart_, source.t, strip_width * radius_);
    const auto distances = polyhedral_distances(surface, strip, source.at);
    if (!distances) return;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!reads(nodes_[i])) continue;
      of_node_[i].push_back({source.t, (*distances)[local_index(strip.vertices, chart_.vertex[nodes_[i]])]});
    }
  }

  std::vector<ExactNode> evaluated() const {
    std::vector<ExactNode> exact;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (const auto found = nearest_point(nodes_[i], chart_.t[nodes_[i]], of_node_[i]))
        exact.push_back(*found);
    }
    return exact;
  }

 private:
  const Chart& chart_;
  std::span<const std::size_t> nodes_;
  double radius_;
  std::vector<std::vector<Reading>> of_node_;  ///< ascending t
};

}  // namespace

std::vector<ExactNode> exact_nodes(const Surface& surface, const SurfaceCurve& curve, const Chart& chart,
                                   double radius, std::span<const std::size_t> nodes) {
  Readings readings(chart, nodes, radius);
  for (const CurvePoint* source : spaced_points(curve, source_spacing * radius))
    readings.take(surface, *source);
  return readings.evaluated();
}

}  // namespace burin::test
