#include <burin/chart/chart_triangles.h>
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "support/closed_curve.h"
#include "support/point_shapes.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

/// Counts the chart triangles of each triangle of the surface, and checks that each has nodes of its own
/// corners that are close to each other, and no node twice.
std::vector<int> counted(const Surface& surface, const Chart& chart, double edge) {
  std::vector<int> counts(surface.triangles.size(), 0);
  std::set<std::pair<Index, Index>> used;
  for (const ChartTriangle& found : chart_triangles(surface, chart)) {
    ++counts[found.triangle];
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(chart.vertex[found.nodes[i]], surface.triangles[found.triangle][i]);
      EXPECT_TRUE(used.insert({found.triangle, found.nodes[i]}).second);
    }
    EXPECT_LT(std::ranges::max(found.t) - std::ranges::min(found.t), 10 * edge);
    EXPECT_GE(std::ranges::min(found.t), chart.closed ? 0 : -1);
  }
  return counts;
}

TEST(ChartTriangles, AreThoseOfTheRegionOnceForEachSheet) {
  const double edge = 0.02, radius = 0.25;
  const Surface surface = make_surface(test::shuffled(test::plane(1, edge, 31), 32));
  const Picker picker(surface);
  // The runs of the hairpin are 0.4 apart: each alone above 0.05 and below -0.05, both between.
  const SurfaceCurve curve = test::traced(surface, picker, radius,
                                          {{-0.6, 0.2, 0},
                                           {0, 0.2, 0},
                                           {0.4, 0.2, 0},
                                           {0.6, 0, 0},
                                           {0.4, -0.2, 0},
                                           {0, -0.2, 0},
                                           {-0.6, -0.2, 0}});
  const Chart chart = StrokeChartBuilder(surface).chart(curve, {radius, Cap::round});
  const std::vector<int> counts = counted(surface, chart, edge);
  std::size_t once = 0, twice = 0, none = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    float least = 1, most = 0;
    bool aside = false;
    for (const Index corner : surface.triangles[i]) {
      const Vec3f& x = surface.positions[corner];
      least = std::min(least, std::abs(x.y()));
      most = std::max(most, std::abs(x.y()));
      aside |= x.x() < -0.55F || x.x() > 0;
    }
    if (aside) continue;
    if (most < 0.04F) {
      EXPECT_EQ(counts[i], 2);
      ++twice;
    } else if (least > 0.06F && most < 0.44F) {
      EXPECT_EQ(counts[i], 1);
      ++once;
    } else if (least > 0.46F) {
      EXPECT_EQ(counts[i], 0);
      ++none;
    }
  }
  EXPECT_GT(once, 500U);
  EXPECT_GT(twice, 80U);
  EXPECT_GT(none, 500U);
}

TEST(ChartTriangles, GoOnAcrossTheSeamOfAClosedStroke) {
  const Surface surface = make_surface(test::shuffled(test::cylinder(1, 1, 0.05, 0.3, 5), 6));
  const Picker picker(surface);
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 60; ++i) {
    const double angle = 2 * std::numbers::pi * i / 60;
    samples.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  SurfaceCurve curve = test::traced(surface, picker, 0.3, samples);
  test::close(curve);
  const Chart chart = StrokeChartBuilder(surface).chart(curve, {0.3, Cap::round});
  const std::vector<int> counts = counted(surface, chart, 0.05);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto within = [&](Index corner) { return std::abs(surface.positions[corner].z()) < 0.29F; };
    if (!std::ranges::all_of(surface.triangles[i], within)) continue;
    EXPECT_EQ(counts[i], 1);
    ++inside;
  }
  EXPECT_GT(inside, 1000U);
}

TEST(ChartTriangles, DoNotStandAroundALoopOfOneTriangle) {
  const Surface surface = make_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  Chart chart;
  chart.vertex = {0, 1, 2};
  chart.sheet = {0, 0, 0};
  chart.t = {0, 1, 2};
  chart.d = {0.1F, 0.1F, 0.1F};
  chart.e1.assign(3, Vec3f::UnitX());
  chart.stretch.assign(3, 1);
  chart.length = 3;
  EXPECT_EQ(chart_triangles(surface, chart).size(), 1U);
  chart.closed = true;
  EXPECT_TRUE(chart_triangles(surface, chart).empty());
}

// A vertex with one node lies beside vertices with two, as where the visits of a bend meet.
TEST(ChartTriangles, UseANodeOnce) {
  const Surface surface = make_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  Chart chart;
  chart.vertex = {0, 1, 1, 2, 2};
  chart.sheet = {0, 0, 1, 0, 1};
  chart.t = {0, 0.9, 1.5, 0.5, 1.4};
  chart.d.assign(5, 0.1F);
  chart.e1.assign(5, Vec3f::UnitX());
  chart.stretch.assign(5, 1);
  const auto found = chart_triangles(surface, chart);
  ASSERT_EQ(found.size(), 1U);
  std::array<Index, 3> nodes = found[0].nodes;
  std::ranges::sort(nodes);
  EXPECT_EQ(nodes, (std::array<Index, 3>{0, 1, 3}));
}

TEST(ChartTriangles, AreNotOfPointSets) {
  const Surface surface = make_point_surface(test::plane_points(1, 0.1, 51));
  const Picker picker(surface);
  const SurfaceCurve curve = test::traced(surface, picker, 0.3, {{-0.5, 0.1, 0}, {0.5, 0.1, 0}});
  const Chart chart = StrokeChartBuilder(surface).chart(curve, {0.3, Cap::butt});
  EXPECT_GT(chart.size(), 20U);
  EXPECT_TRUE(chart_triangles(surface, chart).empty());
}

}  // namespace
}  // namespace burin
