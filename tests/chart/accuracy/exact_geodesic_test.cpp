// Tests the oracle exact_nodes() itself, on surfaces that unroll to the plane without distortion.
#include "support/oracles/exact_geodesic.h"

#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

struct GeodesicScene {
  Surface surface;
  Picker picker;
  explicit GeodesicScene(TriangleMesh mesh) : surface(make_surface(std::move(mesh))), picker(surface) {}

  SurfaceCurve traced(double radius, const std::vector<Vec3d>& samples) const {
    return test::traced(surface, picker, radius, samples);
  }
  Chart chart(const SurfaceCurve& curve, double radius) const {
    return StrokeChartBuilder(surface).chart(curve, {radius, Cap::butt});
  }
  Vec3d position(Index vertex) const { return surface.positions[vertex].cast<double>(); }
};

/// The nodes of this chart at least `margin` away from its ends.
std::vector<std::size_t> inner_nodes(const Chart& chart, const SurfaceCurve& curve, double margin) {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    if (chart.t[i] > margin && chart.t[i] < curve.length() - margin) nodes.push_back(i);
  }
  return nodes;
}

struct Foot {
  double distance, t;
};

/// The foot point, in the plane, on the curve's polyline.
Foot foot_on_chords(const SurfaceCurve& curve, const Vec3d& x) {
  Foot nearest = {1e9, 0};
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const CurvePoint &from = curve.points[i - 1], &to = curve.points[i];
    const Vec3d a = from.at.position.cast<double>(), chord = to.at.position.cast<double>() - a;
    const double s = std::clamp((x - a).dot(chord) / chord.squaredNorm(), 0., 1.);
    const double distance = (x - a - s * chord).norm();
    if (distance < nearest.distance) nearest = {distance, from.t + s * (to.t - from.t)};
  }
  return nearest;
}

TEST(ExactGeodesic, IsTheDistanceInThePlane) {
  const double radius = 0.2;
  const GeodesicScene scene(test::shuffled(test::plane(0.6, 0.01, 7), 8));
  std::vector<Vec3d> samples;
  for (double x = -0.3; x < 0.3; x += 0.02) samples.emplace_back(x, 0.03 * std::sin(8 * x), 0);
  const SurfaceCurve curve = scene.traced(radius, samples);
  const Chart chart = scene.chart(curve, radius);
  const auto inner = inner_nodes(chart, curve, radius / 4);
  const auto exact = test::exact_nodes(scene.surface, curve, chart, radius, inner);
  EXPECT_EQ(exact.size(), inner.size());
  EXPECT_GT(exact.size(), 1500U);
  for (const test::ExactNode& node : exact) {
    const Vec3d x = scene.position(chart.vertex[node.node]);
    const Foot foot = foot_on_chords(curve, x);
    EXPECT_NEAR(node.distance, foot.distance, 2e-4 * radius) << x.transpose();
    EXPECT_NEAR(node.t, foot.t, 1e-2 * radius) << x.transpose();
    EXPECT_GE(node.distance_to_own_t, node.distance);
    EXPECT_GT(node.convexity, 0.5);
  }
}

// The shortest path from ruling to ruling is straight across the facets between them.
TEST(ExactGeodesic, IsTheDistanceAroundAPrism) {
  const double radius = 0.5, pi = std::numbers::pi, half_side = pi / std::round(2 * pi / 0.025);
  const GeodesicScene scene(test::shuffled(test::cylinder(1, 0.6, 0.025, 0, 5), 6));
  std::vector<Vec3d> samples;
  for (double z = -0.55; z < 0.56; z += 0.05) samples.emplace_back(1, 0, z);
  const SurfaceCurve curve = scene.traced(radius, samples);
  const Chart chart = scene.chart(curve, radius);
  const auto exact = test::exact_nodes(scene.surface, curve, chart, radius, inner_nodes(chart, curve, 0.1));
  EXPECT_GT(exact.size(), 300U);
  for (const test::ExactNode& node : exact) {
    const Vec3d x = scene.position(chart.vertex[node.node]);
    const double sides = std::abs(std::atan2(x.y(), x.x())) / (2 * half_side);
    EXPECT_NEAR(node.distance, sides * 2 * std::sin(half_side), 1e-5 * radius) << x.transpose();
    EXPECT_NEAR(node.t, x.z() + 0.55, 1e-4 * radius) << x.transpose();
    EXPECT_NEAR(node.convexity, 1, 1e-3);
  }
}

TEST(ExactGeodesic, HasNothingToSayWhereThreeTrianglesShareAnEdge) {
  const GeodesicScene scene({{{0, 0, 0}, {1, 0, 0}, {0.5F, 0.2F, 0}, {0.5F, -0.2F, 0}, {0.5F, 0, 0.2F}},
                             {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  const SurfaceCurve curve = scene.traced(0.5, {{0.2, 0.1, 0}, {0.8, 0.1, 0}});
  const Chart chart = scene.chart(curve, 0.5);
  const auto inner = inner_nodes(chart, curve, 0.05);
  EXPECT_FALSE(inner.empty());
  EXPECT_TRUE(test::exact_nodes(scene.surface, curve, chart, 0.5, inner).empty());
}

}  // namespace
}  // namespace burin
