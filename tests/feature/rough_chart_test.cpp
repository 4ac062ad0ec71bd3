// Rough charts against those of StrokeChartBuilder.
#include <burin/chart/stroke_chart_builder.h>
#include <burin/feature/rough_chart.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "feature/known_lines.h"
#include "support/closed_curve.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin::test {
namespace {

/// What two charts have in common: nodes of the same vertex and visit.
struct Comparison {
  double mean_d = 0, mean_t = 0, worst_d = 0;  ///< differences, radii
  double shared = 0;                           ///< share of the nodes of both that the other has, too
  std::size_t second_sheets = 0;               ///< of the shared ones
};

Comparison compare(const Chart& rough, const Chart& exact, double radius) {
  Comparison sums;
  double count = 0;
  for (std::size_t i = 0, k = 0; i < exact.size(); ++i) {
    const auto before = [&](std::size_t a) {
      return std::pair(rough.vertex[a], rough.sheet[a]) < std::pair(exact.vertex[i], exact.sheet[i]);
    };
    while (k < rough.size() && before(k)) ++k;
    if (k == rough.size()) break;
    if (rough.vertex[k] != exact.vertex[i] || rough.sheet[k] != exact.sheet[i]) continue;
    const double d = std::abs(static_cast<double>(exact.d[i] - rough.d[k])) / radius;
    double t = std::abs(exact.t[i] - rough.t[k]);
    if (exact.closed) t = std::min(t, exact.length - t);
    ++count;
    sums.mean_d += d;
    sums.mean_t += t / radius;
    sums.worst_d = std::max(sums.worst_d, d);
    sums.second_sheets += exact.sheet[i] > 0;
  }
  sums.mean_d /= count;
  sums.mean_t /= count;
  sums.shared = 2 * count / static_cast<double>(rough.size() + exact.size());
  return sums;
}

Comparison compare_on(const Surface& surface, const SurfaceCurve& curve, double radius) {
  StrokeChartBuilder builder(surface);
  RoughCharter charter(surface);
  const Chart first = charter.chart(curve, radius);
  const Chart again = charter.chart(curve, radius);
  EXPECT_EQ(first.t, again.t) << "nothing stays from call to call";
  EXPECT_EQ(first.vertex, again.vertex);
  return compare(first, builder.chart(curve, {.radius = radius}), radius);
}

TEST(RoughChart, IsNearTheChartOfAWeavingStrokeOverARidge) {
  const KnownLine known = ridge_on_sphere(5, 2.5, 150, 0.9, 18, 120, 3);
  SnapScene scene(known.mesh);
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) pen.push_back(known.beside(i / 60., 5 + 3 * std::sin(i / 5.)));
  const Comparison result = compare_on(scene.surface, traced(scene.surface, scene.picker, 18, pen), 18);
  EXPECT_LT(result.mean_d, 1e-3);
  EXPECT_LT(result.mean_t, 7e-3);
  EXPECT_LT(result.worst_d, 0.02);
  EXPECT_GT(result.shared, 0.999);
}

TEST(RoughChart, HasASheetPerVisit) {
  // A hairpin, whose legs are half a radius apart and ten radii long.
  SnapScene scene(shuffled(plane(40, 1, 5), 6));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) pen.emplace_back(i - 30, -1.5, 0);
  for (int i = 60; i >= 0; --i) pen.emplace_back(i - 30, 1.5, 0);
  const Comparison result = compare_on(scene.surface, traced(scene.surface, scene.picker, 6, pen), 6);
  EXPECT_GT(result.second_sheets, 300u);
  EXPECT_GT(result.shared, 0.85) << "near the bend visits are told apart otherwise";
  EXPECT_LT(result.mean_d, 0.03);
}

TEST(RoughChart, DoesNotGoStraightOnWhereTheStrokeTurns) {
  SnapScene scene(shuffled(plane(60, 1, 5), 6));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) pen.emplace_back(i - 50, -20, 0);
  for (int i = 1; i <= 60; ++i) pen.emplace_back(10, i - 20, 0);
  const Comparison result = compare_on(scene.surface, traced(scene.surface, scene.picker, 10, pen), 10);
  EXPECT_GT(result.shared, 0.97);
  EXPECT_LT(result.mean_d, 0.01);
}

TEST(RoughChart, GoesAroundClosedStrokes) {
  SnapScene scene(shuffled(sphere(5, 0.25, 3), 4));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 90; ++i) {
    const double s = 2 * std::numbers::pi * i / 90;
    pen.push_back(Vec3d(std::cos(s), std::sin(s), 0.5).normalized());
  }
  SurfaceCurve curve = traced(scene.surface, scene.picker, 0.3, pen);
  close(curve);
  const Comparison result = compare_on(scene.surface, curve, 0.3);
  EXPECT_LT(result.mean_d, 1e-3);
  EXPECT_LT(result.mean_t, 5e-3);
  EXPECT_GT(result.shared, 0.99);
}

}  // namespace
}  // namespace burin::test
