// Tests strokes that overlap themselves, on a plane: the sheet of each visit has the coordinates of its
// own part of the stroke.
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

constexpr double stacked_radius = 0.15, sheet_edge = 0.01, pi = std::numbers::pi;

struct Scene {
  Surface surface = make_surface(test::shuffled(test::plane(1, sheet_edge, 15), 16));
  Picker picker{surface};
  StrokeChartBuilder builder{surface};

  SurfaceCurve traced(const std::vector<Vec3d>& samples) const {
    return test::traced(surface, picker, stacked_radius, samples);
  }
};

struct FootOfSheet {
  double t, d;
};

/// All feet within the radius: local minima of the distance along the curve, by rising t.
std::vector<FootOfSheet> feet_of(const SurfaceCurve& curve, const Vec3d& x) {
  std::vector<FootOfSheet> feet;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const Vec3d a = curve.points[i].at.position.cast<double>(),
                b = curve.points[i + 1].at.position.cast<double>();
    const Vec3d chord = b - a;
    const double s = (x - a).dot(chord) / chord.squaredNorm();
    if (s < -0.2 || s > 1.2) continue;  // on the outside of joints no foot is within either segment
    const double side = chord.x() * (x - a).y() - chord.y() * (x - a).x();
    const double distance = (x - a - s * chord).norm();
    if (distance > stacked_radius) continue;
    const double t = curve.points[i].t + s * (curve.points[i + 1].t - curve.points[i].t);
    if (feet.empty() || t - feet.back().t > stacked_radius / 4)
      feet.push_back({t, std::copysign(distance, side)});
  }
  return feet;
}

/// Compares the sheets of vertices that `counts` with their feet. Returns how many vertices have how many.
template <class Counts>
std::map<std::size_t, std::size_t> expect_sheets_at_feet(const Scene& scene, const SurfaceCurve& curve,
                                                         const Chart& chart, const Counts& counts) {
  std::map<std::size_t, std::size_t> vertices;
  for (std::size_t i = 0; i < chart.size();) {
    std::size_t end = i;
    while (end < chart.size() && chart.vertex[end] == chart.vertex[i]) ++end;
    const Vec3d x = scene.surface.positions[chart.vertex[i]].cast<double>();
    if (counts(x)) {
      const std::vector<FootOfSheet> feet = feet_of(curve, x);
      const bool on_border = std::ranges::any_of(
          feet, [](const FootOfSheet& foot) { return std::abs(foot.d) > stacked_radius - sheet_edge / 2; });
      if (!on_border) {
        EXPECT_EQ(end - i, feet.size()) << x.transpose();
        for (std::size_t k = i; k < std::min(end, i + feet.size()); ++k) {
          EXPECT_NEAR(chart.t[k], feet[k - i].t, 0.02 * stacked_radius)
              << x.transpose() << " sheet " << k - i;
          EXPECT_NEAR(chart.d[k], feet[k - i].d, 0.01 * stacked_radius)
              << x.transpose() << " sheet " << k - i;
        }
        ++vertices[end - i];
      }
    }
    i = end;
  }
  return vertices;
}

/// Five straight runs through the origin, joined by wide turns.
std::vector<Vec3d> five_crossings() {
  std::vector<Vec3d> samples;
  for (int run = 0; run < 5; ++run) {
    const double angle = 4 * pi / 5 * run;
    const Vec3d along(std::cos(angle), std::sin(angle), 0);
    for (int i = 0; i < 60; ++i) samples.emplace_back((-0.6 + 1.2 * i / 60) * along);
    // The connection runs on a circle around the origin from the end of this line to the start of the next.
    if (run == 4) continue;
    const double from = angle, to = angle + 4 * pi / 5 - pi;
    for (int i = 0; i < 20; ++i) {
      const double a = from + (to - from) * i / 20., out = 0.6 + 0.3 * std::sin(pi * i / 20.);
      samples.emplace_back(out * std::cos(a), out * std::sin(a), 0);
    }
  }
  return samples;
}

TEST(Sheets, FiveFoldCrossingHasFive) {
  Scene scene;
  const SurfaceCurve curve = scene.traced(five_crossings());
  const Chart chart = scene.builder.chart(curve, {.radius = stacked_radius});
  const auto vertices =
      expect_sheets_at_feet(scene, curve, chart, [](const Vec3d& x) { return x.norm() < 0.3; });
  ASSERT_TRUE(vertices.contains(5));
  EXPECT_GT(vertices.at(5), 400U);
  EXPECT_GT(vertices.size(), 4U);
}

TEST(Sheets, FigureEightHasTwoWhereItCrosses) {
  Scene scene;
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 300; ++i) {
    const double a = 2 * pi * i / 300 + pi / 2;
    samples.emplace_back(0.7 * std::sin(a), 0.5 * std::sin(2 * a), 0);
  }
  const SurfaceCurve curve = scene.traced(samples);
  const Chart chart = scene.builder.chart(curve, {.radius = stacked_radius});
  const auto vertices =
      expect_sheets_at_feet(scene, curve, chart, [](const Vec3d& x) { return x.norm() < 0.35; });
  EXPECT_GT(vertices.at(2), 200U);
  EXPECT_EQ(vertices.rbegin()->first, 2U);
}

TEST(Sheets, SpiralOverlapsItselfAlongItsWholeLength) {
  Scene scene;
  std::vector<Vec3d> samples;
  const double pitch = stacked_radius;  // both neighbouring turns reach to the middle of this one
  for (int i = 0; i <= 500; ++i) {
    const double a = 3 * 2 * pi * i / 500, out = 0.35 + pitch * a / (2 * pi);
    samples.emplace_back(out * std::cos(a), out * std::sin(a), 0);
  }
  const SurfaceCurve curve = scene.traced(samples);
  const Chart chart = scene.builder.chart(curve, {.radius = stacked_radius});
  // Away from where the turns begin and end.
  const auto vertices = expect_sheets_at_feet(
      scene, curve, chart, [](const Vec3d& x) { return x.norm() > 0.45 && x.norm() < 0.75 && x.x() < -0.1; });
  EXPECT_GT(vertices.at(2), 1500U);
  // The number of nodes corresponds to the area of the stroke, however often it overlaps itself.
  const double area = 2 * stacked_radius * curve.length() + pi * stacked_radius * stacked_radius;
  const double cell = 4. / scene.surface.vertex_count();
  EXPECT_NEAR(static_cast<double>(chart.size()) * cell, area, 0.03 * area);
}

TEST(Sheets, StrokeDrawnBackOverItselfHasASheetForEachWay) {
  Scene scene;
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 60; ++i) samples.emplace_back(-0.7 + 1.4 * i / 60, 0.013, 0);
  for (int i = 1; i <= 60; ++i) samples.emplace_back(0.7 - 1.4 * i / 60, 0.013, 0);
  const SurfaceCurve curve = scene.traced(samples);
  const Chart chart = scene.builder.chart(curve, {.radius = stacked_radius});
  const auto vertices = expect_sheets_at_feet(
      scene, curve, chart, [](const Vec3d& x) { return x.x() > -0.6 && x.x() < 0.7 - 1.5 * stacked_radius; });
  EXPECT_GT(vertices.at(2), 2000U);
  EXPECT_EQ(vertices.size(), 1U);
}

SurfaceCurve closed_circle(const Scene& scene, double size) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 400; ++i) {
    const double a = 2 * pi * i / 400;
    samples.emplace_back(size * std::cos(a), size * std::sin(a), 0);
  }
  SurfaceCurve curve = scene.traced(samples);
  curve.closed = true;
  curve.closing_length = curve.points.back().t - curve.points[curve.points.size() - 2].t;
  curve.points.pop_back();
  // The tangents at the seam as they are all along the circle.
  const Vec3f& first = curve.points.front().at.position;
  curve.points.front().tangent = Vec3f(-first.y(), first.x(), 0).normalized();
  return curve;
}

TEST(ClosedStroke, IsACylinderWithoutASeam) {
  Scene scene;
  const double size = 0.5;
  const SurfaceCurve curve = closed_circle(scene, size);
  const Chart chart = scene.builder.chart(curve, {.radius = stacked_radius});
  EXPECT_TRUE(chart.closed);
  EXPECT_NEAR(chart.length, 2 * pi * size, 1e-4);
  std::size_t at_seam = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec3f& x = scene.surface.positions[chart.vertex[i]];
    EXPECT_EQ(chart.sheet[i], 0U);
    ASSERT_TRUE(chart.t[i] >= 0 && chart.t[i] < chart.length);
    EXPECT_NEAR(chart.d[i], size - static_cast<double>(x.norm()), 1e-3 * stacked_radius);
    const double angle = std::atan2(x.y(), x.x());
    double miss = chart.t[i] / size - angle;
    miss -= 2 * pi * std::round(miss / (2 * pi));
    EXPECT_LE(std::abs(miss) * size, 1e-4 * chart.length) << x.transpose();
    at_seam += std::abs(angle) * size < 5 * sheet_edge;
  }
  const double area = 2 * stacked_radius * chart.length, cell = 4. / scene.surface.vertex_count();
  EXPECT_NEAR(static_cast<double>(chart.size()) * cell, area, 0.02 * area);
  EXPECT_GT(at_seam, 200U);
}

TEST(ClosedStroke, SmallerThanItsRadiusStaysFinite) {
  Scene scene;
  const Chart chart = scene.builder.chart(closed_circle(scene, 0.05), {.radius = stacked_radius});
  EXPECT_GT(chart.size(), 500U);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double out = static_cast<double>(scene.surface.positions[chart.vertex[i]].norm());
    EXPECT_EQ(chart.sheet[i], 0U);
    if (out > 0.02) {
      EXPECT_NEAR(chart.d[i], 0.05 - out, 0.02 * stacked_radius);
    }
  }
}

}  // namespace
}  // namespace burin
