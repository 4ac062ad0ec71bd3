#include "subject.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace burin::paper {
namespace {

/// One sheet a vertex, the nearest to the stroke: what the chart is compared with knows no other maps.
Chart nearest_sheets(const Chart& chart) {
  Chart nearest;
  nearest.length = chart.length;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const bool again = i > 0 && chart.vertex[i] == chart.vertex[i - 1];
    if (again && std::abs(chart.d[i]) >= std::abs(nearest.d.back())) continue;
    if (!again) {
      nearest.vertex.push_back(chart.vertex[i]);
      nearest.sheet.push_back(0);
    }
    nearest.t.resize(nearest.vertex.size());
    nearest.d.resize(nearest.vertex.size());
    nearest.e1.resize(nearest.vertex.size());
    nearest.stretch.resize(nearest.vertex.size());
    nearest.t.back() = chart.t[i];
    nearest.d.back() = chart.d[i];
    nearest.e1.back() = chart.e1[i];
    nearest.stretch.back() = chart.stretch[i];
  }
  return nearest;
}

bool inside(const Chart& chart, const Triangle& triangle) {
  return std::ranges::all_of(triangle,
                             [&](Index vertex) { return std::ranges::binary_search(chart.vertex, vertex); });
}

int shared_corners(const Triangle& a, const Triangle& b) {
  return static_cast<int>(
      std::ranges::count_if(a, [&](Index corner) { return std::ranges::find(b, corner) != b.end(); }));
}

test::Region region_of(const Surface& surface, const SurfaceCurve& curve, const Chart& chart) {
  std::set<Index> reached;
  std::vector<Index> stack, triangles;
  for (const CurvePoint& point : curve.points) stack.push_back(point.at.triangle);
  while (!stack.empty()) {
    const Index triangle = stack.back();
    stack.pop_back();
    if (!reached.insert(triangle).second || !inside(chart, surface.triangles[triangle])) continue;
    triangles.push_back(triangle);
    // Across edges only: what hangs on one vertex could turn freely.
    for (const Index vertex : surface.triangles[triangle]) {
      for (const Index around : surface.incident[vertex])
        if (shared_corners(surface.triangles[triangle], surface.triangles[around]) == 2)
          stack.push_back(around);
    }
  }
  return test::make_region(surface, std::move(triangles));
}

}  // namespace

Subject make_subject(const Scene& scene, SurfaceCurve curve, double radius) {
  Subject subject{&scene, radius, std::move(curve), {}, {}};
  subject.chart =
      nearest_sheets(StrokeChartBuilder(scene.surface).chart(subject.curve, {radius, Cap::round}));
  subject.region = region_of(scene.surface, subject.curve, subject.chart);
  return subject;
}

Parameterization chart_coordinates(const Subject& subject) {
  Parameterization places(static_cast<Eigen::Index>(subject.region.vertices.size()), 2);
  for (std::size_t node = 0; node < subject.chart.size(); ++node) {
    const Index local = test::local_index(subject.region.vertices, subject.chart.vertex[node]);
    if (local == no_index) continue;
    places.row(local) << subject.chart.t[node], static_cast<double>(subject.chart.d[node]);
  }
  return places;
}

std::vector<test::ExactNode> measured_nodes(const Subject& subject) {
  constexpr double clear = 0.3;
  const double margin = subject.radius / 2;
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < subject.chart.size(); ++i) {
    const double t = subject.chart.t[i];
    const bool in_region = test::local_index(subject.region.vertices, subject.chart.vertex[i]) != no_index;
    if (in_region && t > margin && t < subject.curve.length() - margin) nodes.push_back(i);
  }
  auto exact = test::exact_nodes(subject.scene->surface, subject.curve, subject.chart, subject.radius, nodes);
  std::erase_if(exact, [](const test::ExactNode& node) { return node.convexity < clear; });
  return exact;
}

double DistanceError::mean() const {
  return std::accumulate(errors.begin(), errors.end(), 0.) / static_cast<double>(errors.size());
}

double DistanceError::max() const { return errors.empty() ? 0 : std::ranges::max(errors); }

DistanceError distance_error(const Subject& subject, std::span<const test::ExactNode> exact,
                             const Parameterization& places) {
  DistanceError error;
  for (const test::ExactNode& node : exact) {
    const Index vertex = subject.chart.vertex[node.node];
    const Index local = test::local_index(subject.region.vertices, vertex);
    error.vertices.push_back(vertex);
    error.errors.push_back(100 / subject.radius * std::abs(std::abs(places(local, 1)) - node.distance));
  }
  return error;
}

double flipped(const test::Region& region, const Parameterization& places) {
  const auto turns_over = [&](const Triangle& corners) {
    const Vec2d a = places.row(corners[0]), b = places.row(corners[1]), c = places.row(corners[2]);
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() <= 0;
  };
  return 100 * static_cast<double>(std::ranges::count_if(region.corners, turns_over)) /
         static_cast<double>(region.corners.size());
}

}  // namespace burin::paper
