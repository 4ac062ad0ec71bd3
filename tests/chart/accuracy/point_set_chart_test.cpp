// Tests charts on point sets, whose points have neighbours but no triangles.
#include <burin/chart/dabs/dab.h>
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "support/chart_error.h"
#include "support/point_shapes.h"
#include "support/scene.h"
#include "support/straight_stroke.h"
#include "support/traced.h"

namespace burin {
namespace {

using test::ChartError;
using test::Coordinates;
using test::error_against;
using test::error_of_straight_stroke;
using test::sampled;
using test::Scene;

TEST(PointSetChart, IsExactForAStraightStrokeOnAPlane) {
  Scene scene(test::plane_points(1, 0.01, 7));
  const ChartError error = error_of_straight_stroke(scene);
  EXPECT_GT(error.count, 4000U);
  EXPECT_LE(error.t_mean, 1e-6);
  EXPECT_LE(error.t_max, 1e-4);
  EXPECT_LE(error.d_max, 1e-5);
}

TEST(PointSetChart, IsCloseAlongACylinder) {
  const double radius = 0.3;
  Scene scene(test::cylinder_points(radius / 20, 5));
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, radius,
                                          sampled(60, [](double s) { return Vec3d(1, 0, -0.8 + 1.6 * s); }));
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round});
  const auto error = error_against(scene.surface, chart, curve.length(), radius, 0, [](const Vec3d& x) {
    return Coordinates{x.z() + 0.8, -std::atan2(x.y(), x.x())};
  });
  EXPECT_GT(error.count, 3000U);
  EXPECT_LE(error.t_max, 1e-5);
  EXPECT_LE(error.d_max, 1e-5);
}

TEST(PointSetChart, FollowsAGreatCircleOfTheSphere) {
  Scene scene(test::sphere_points(6, 11));
  const double radius = 0.3;
  const SurfaceCurve curve =
      test::traced(scene.surface, scene.picker, radius,
                   sampled(120, [](double s) { return Vec3d(std::cos(2 * s), std::sin(2 * s), 0); }));
  EXPECT_NEAR(curve.length(), 2, 1e-3);
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round});
  const auto error = error_against(scene.surface, chart, 2, radius, radius / 2, [](const Vec3d& x) {
    return Coordinates{std::atan2(x.y(), x.x()), std::asin(x.z() / x.norm())};
  });
  EXPECT_GT(error.count, 3000U);
  EXPECT_LE(error.t_mean, 0.0005);
  EXPECT_LE(error.t_max, 0.006);
  EXPECT_LE(error.d_mean, 0.001);
  EXPECT_LE(error.d_max, 0.004);
}

/// The chart of one stroke on a sphere whose points come in this order, with the points' numbers there.
std::pair<Surface, Chart> chart_in_order(std::uint32_t order) {
  const TriangleMesh mesh = test::shuffled(test::sphere(4, 0.2, 5), order);
  Scene scene(test::points_of(mesh, [](const Vec3f& x) { return x; }));
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, 0.3, sampled(20, [](double s) {
                                            return Vec3d(std::cos(s), std::sin(s), 0.3 * s).normalized();
                                          }));
  Chart chart = scene.builder.chart(curve, {0.3, Cap::round});
  return {std::move(scene.surface), std::move(chart)};
}

TEST(PointSetChart, DoesNotDependOnTheOrderOfTheInput) {
  const auto [a_surface, a] = chart_in_order(1);
  const auto [b_surface, b] = chart_in_order(2);
  EXPECT_GT(a.size(), 150U);
  EXPECT_NE(a_surface.source_vertex, b_surface.source_vertex);
  EXPECT_EQ(a.vertex, b.vertex);
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.d, b.d);
  EXPECT_EQ(a.e1, b.e1);
}

constexpr double relief_radius = 0.4;

/// Points of a rectangle with an egg crate on it, heights in shares of the radius, its wavelength 0.35 radii.
/// Points and normals are sampled with noise of a tenth of their distance and of 6 degrees where there are
/// bumps.
PointSet bumpy_points(double height) {
  const double k = 2 * std::numbers::pi / (0.35 * relief_radius), a = height * relief_radius;
  PointSet points = test::plane_points(1.3, relief_radius / 20, 5);
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0, height > 0 ? 0.1 : 0);
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const Vec3d at = points.positions[i].cast<double>();
    const double sx = std::sin(k * at.x()), sy = std::sin(k * at.y());
    const double cx = std::cos(k * at.x()), cy = std::cos(k * at.y());
    points.positions[i].z() = static_cast<float>(a * sx * sy + noise(random) * relief_radius / 20);
    const Vec3d normal = Vec3d(-a * k * cx * sy, -a * k * sx * cy, 1).normalized();
    points.normals[i] = (normal + Vec3d(noise(random), noise(random), noise(random))).cast<float>();
  }
  return points;
}

/// The displacement of each point by a groove of depth 1, by index.
std::vector<Vec3d> groove_along(const Surface& surface, const Chart& chart) {
  std::vector<Vec3d> moves(surface.vertex_count(), Vec3d::Zero());
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double beyond = std::max({-chart.t[i], chart.t[i] - chart.length, 0.});
    const double x = std::hypot(beyond, static_cast<double>(chart.d[i])) / relief_radius;
    moves[surface.source_vertex[chart.vertex[i]]] = -std::pow(1 - x * x, 2) * chart.normal[i].cast<double>();
  }
  return moves;
}

std::vector<Vec3d> groove_on(double height) {
  const Surface surface = make_point_surface(bumpy_points(height));
  const Picker picker(surface);
  const SurfaceLevels levels(surface);
  StrokeChartBuilder builder(surface, &levels);
  const ChartOptions options{.radius = relief_radius, .follow = 0};
  builder.begin(options);
  EXPECT_TRUE(builder.base());
  const CurveGround ground(surface, picker, builder.base());
  CurveTracer tracer(ground, relief_radius);
  for (int i = 0; i <= 100; ++i) {
    const float x = -0.7F + 0.014F * static_cast<float>(i);
    const auto at = ground.closest(Vec3f(x, 0.1F * std::sin(3 * x), 0), 0.3F);
    EXPECT_TRUE(at && tracer.connects(*at));
    if (at) tracer.add(*at, i, {});
  }
  return groove_along(surface, builder.chart(tracer.curve(), options));
}

// Root mean square over the points that either stroke moves, in percent of the depth.
TEST(PointSetChart, AddsToReliefWhatItAddsToTheBarePlane) {
  const std::vector<Vec3d> expected = groove_on(0);
  for (const auto& [height, percent] : {std::pair(0.01, 0.5), {0.05, 1.}, {0.12, 2.}, {0.25, 5.}}) {
    const std::vector<Vec3d> moves = groove_on(height);
    double squares = 0, count = 0;
    for (std::size_t v = 0; v < moves.size(); ++v) {
      if (moves[v].isZero(0) && expected[v].isZero(0)) continue;
      squares += (moves[v] - expected[v]).squaredNorm();
      ++count;
    }
    ASSERT_GT(count, 3000);
    EXPECT_LT(100 * std::sqrt(squares / count), percent) << "bumps of " << height;
  }
}

TEST(PointSetChart, ChartsDabsToo) {
  Scene scene(test::plane_points(1, 0.02, 7));
  DabChartBuilder builder(scene.surface);
  const SurfacePoint centre = scene.picker.closest({0.123F, -0.2F, 0}, 1).value();
  for (const DabMethod method : {DabMethod::dem, DabMethod::dem_upwind, DabMethod::frame_propagation}) {
    const DabChart chart = builder.chart(centre, Vec3f::UnitX(), {0.3, method});
    EXPECT_GT(chart.size(), 600U);
    for (std::size_t i = 0; i < chart.size(); ++i) {
      const Vec3f away = scene.surface.positions[chart.vertex[i]] - centre.position;
      ASSERT_LT((Vec2f(chart.u[i], chart.v[i]) - away.head<2>()).norm(), 3e-6F);
    }
  }
}

}  // namespace
}  // namespace burin
