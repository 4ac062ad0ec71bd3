// The same charts on points with neighbours instead of triangles.
#include <burin/chart/dab.h>
#include <burin/chart/stroke_chart.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "support/chart_error.h"
#include "support/point_shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

using test::ChartError;
using test::Coordinates;
using test::error_against;
using test::sampled;

struct Scene {
  Surface surface;
  Picker picker;
  StrokeCharter charter;

  explicit Scene(PointSet points)
      : surface(make_point_surface(std::move(points))), picker(surface), charter(surface) {}
};

TEST(PointSetChart, IsExactForAStraightStrokeOnAPlane) {
  Scene scene(test::plane_points(1, 0.01, 7));
  const double radius = 0.2;
  const Vec3d from(-0.5, -0.31, 0), to(0.62, 0.27, 0);
  const Vec3d along = (to - from).normalized(), left(-along.y(), along.x(), 0);
  const SurfaceCurve curve =
      test::traced(scene.surface, scene.picker, radius,
                   sampled(40, [&](double s) { return Vec3d(from + s * (to - from)); }));
  EXPECT_NEAR(curve.length(), (to - from).norm(), 1e-5 * radius);
  const Chart chart = scene.charter.chart(curve, {radius, Cap::round});
  const auto error = error_against(scene.surface, chart, curve.length(), radius, 0, [&](const Vec3d& x) {
    return Coordinates{(x - from).dot(along), (x - from).dot(left)};
  });
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
  const Chart chart = scene.charter.chart(curve, {radius, Cap::round});
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
  const Chart chart = scene.charter.chart(curve, {radius, Cap::round});
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
  Chart chart = scene.charter.chart(curve, {0.3, Cap::round});
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

TEST(PointSetChart, ChartsDabsToo) {
  Scene scene(test::plane_points(1, 0.02, 7));
  DabCharter charter(scene.surface);
  const SurfacePoint centre = scene.picker.closest({0.123F, -0.2F, 0}, 1).value();
  for (const DabMethod method : {DabMethod::dem, DabMethod::dem_upwind, DabMethod::frame_propagation}) {
    const DabChart chart = charter.chart(centre, Vec3f::UnitX(), {0.3, method});
    EXPECT_GT(chart.size(), 600U);
    for (std::size_t i = 0; i < chart.size(); ++i) {
      const Vec3f away = scene.surface.positions[chart.vertex[i]] - centre.position;
      ASSERT_LT((Vec2f(chart.u[i], chart.v[i]) - away.head<2>()).norm(), 3e-6F);
    }
  }
}

}  // namespace
}  // namespace burin
