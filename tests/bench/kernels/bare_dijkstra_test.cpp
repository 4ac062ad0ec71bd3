#include "bare_dijkstra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sphere_stroke.h"

namespace burin::kernels {
namespace {

/// Relaxes every edge until nothing changes. Rounded sums grow with their terms, so that the shortest paths
/// have the same bits in whichever order they are found.
std::vector<float> relaxed(const Surface& surface, const SurfaceCurve& curve) {
  std::vector<float> distance(surface.vertex_count(), std::numeric_limits<float>::infinity());
  for (const CurvePoint& point : curve.points)
    for (const Index corner : point.at.corners)
      distance[corner] = std::min(distance[corner], (surface.positions[corner] - point.at.position).norm());
  for (bool changed = true; changed;) {
    changed = false;
    for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
      for (const Index next : surface.neighbours[vertex]) {
        const float through = distance[next] + (surface.positions[vertex] - surface.positions[next]).norm();
        changed = changed || through < distance[vertex];
        distance[vertex] = std::min(distance[vertex], through);
      }
    }
  }
  return distance;
}

void expect_run(BareDijkstra& dijkstra, const SphereStroke& stroke, float radius,
                const std::vector<float>& expected) {
  const std::span<const Index> reached = dijkstra.run(stroke.curve, radius);
  const auto within = std::ranges::count_if(expected, [&](float each) { return each <= radius; });
  EXPECT_EQ(reached.size(), static_cast<std::size_t>(within));
  float before = 0;
  for (const Index vertex : reached) {
    ASSERT_EQ(dijkstra.distance(vertex), expected[vertex]);
    EXPECT_LE(before, expected[vertex]);
    before = expected[vertex];
  }
}

TEST(BareDijkstra, FindsTheShortestPathsAlongEdges) {
  const SphereStroke& stroke = sphere_stroke(1000);
  const std::vector<float> expected = relaxed(stroke.surface, stroke.curve);
  BareDijkstra dijkstra(stroke.surface);
  const auto radius = static_cast<float>(stroke.radius);
  // The second run must not see the first.
  expect_run(dijkstra, stroke, radius, expected);
  expect_run(dijkstra, stroke, radius / 2, expected);
  EXPECT_GT(std::ranges::count_if(expected, [&](float each) { return each <= radius / 2; }), 100);
}

}  // namespace
}  // namespace burin::kernels
