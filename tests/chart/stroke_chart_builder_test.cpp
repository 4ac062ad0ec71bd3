#include <burin/base/error.h>
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/chart_error.h"
#include "support/same_chart.h"
#include "support/scene.h"
#include "support/shapes.h"
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

TEST(StrokeChart, IsExactForAStraightStrokeOnAPlane) {
  Scene scene(test::shuffled(test::plane(1, 0.01, 7), 8));
  const ChartError error = error_of_straight_stroke(scene);
  EXPECT_GT(error.count, 4000);
  EXPECT_LE(error.t_max, 1e-5);
  EXPECT_LE(error.d_max, 1e-5);
}

TEST(StrokeChart, HoldsExactlyTheVerticesWithinTheStrokeOnAPlane) {
  Scene scene(test::plane(1, 0.02, 3));
  const double radius = 0.25, slack = 1e-5;
  const SurfaceCurve curve =
      test::traced(scene.surface, scene.picker, radius,
                   sampled(11, [](double s) { return Vec3d(-0.4 + 0.8 * s, 0.003, 0); }));
  for (const Cap cap : {Cap::round, Cap::butt}) {
    const Chart chart = scene.builder.chart(curve, {radius, cap});
    std::vector<bool> held(scene.surface.vertex_count(), false);
    for (const Index v : chart.vertex) held[v] = true;
    for (Index v = 0; v < scene.surface.vertex_count(); ++v) {
      const Vec3f& x = scene.surface.positions[v];
      const double beyond = std::max(std::abs(static_cast<double>(x.x())) - 0.4, 0.);
      const double across = std::abs(static_cast<double>(x.y()) - 0.003);
      const double outside = cap == Cap::round ? std::hypot(beyond, across) - radius
                                               : std::max(beyond > 0 ? beyond : -1, across - radius);
      if (std::abs(outside) <= slack) continue;
      EXPECT_EQ(held[v], outside < 0) << x.transpose();
    }
  }
}

TEST(StrokeChart, PutsPositiveDistanceOnTheLeft) {
  Scene scene(test::plane(1, 0.05, 3));
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, 0.3, {{-0.5, 0, 0}, {0.5, 0, 0}});
  const Chart chart = scene.builder.chart(curve, {0.3, Cap::butt});
  ASSERT_GT(chart.size(), 100U);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    EXPECT_NEAR(chart.d[i], scene.surface.positions[chart.vertex[i]].y(), 1e-5F);
    EXPECT_LT((chart.e1[i] - Vec3f::UnitX()).norm(), 1e-5F);
  }
}

ChartError error_along_cylinder(double jitter, int order) {
  const double radius = 0.3;
  Scene scene(test::shuffled(test::cylinder(1, 1, radius / 20, jitter, 5), 6));
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, radius,
                                          sampled(60, [](double s) { return Vec3d(1, 0, -0.8 + 1.6 * s); }));
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round, order});
  // Upwards along the ruling through (1, 0) with the outward normal, the left is the side of falling angle.
  return error_against(scene.surface, chart, curve.length(), radius, 0, [](const Vec3d& x) {
    return Coordinates{x.z() + 0.8, -std::atan2(x.y(), x.x())};
  });
}

TEST(StrokeChart, IsExactAlongACylinder) {
  for (const int order : {1, 2}) {
    const ChartError error = error_along_cylinder(0, order);
    EXPECT_GT(error.count, 3000);
    EXPECT_LE(error.t_max, 1e-5);
    EXPECT_LE(error.d_max, 1e-5);
  }
}

// Vertices off the rulings: the facets are no developable surface any more and the normals no exact ones.
TEST(StrokeChart, StaysCloseAlongAnIrregularCylinder) {
  const ChartError first = error_along_cylinder(0.3, 1), second = error_along_cylinder(0.3, 2);
  EXPECT_LE(first.t_max, 4e-5);
  EXPECT_LE(first.d_max, 2e-5);
  EXPECT_LE(second.t_max, 6e-5);
  EXPECT_LE(second.d_max, 2e-5);
}

TEST(StrokeChart, FollowsAGreatCircleOfTheSphere) {
  Scene scene(test::shuffled(test::sphere(6, 0.15, 11), 12));
  const double radius = 0.3;
  const SurfaceCurve curve =
      test::traced(scene.surface, scene.picker, radius,
                   sampled(120, [](double s) { return Vec3d(std::cos(2 * s), std::sin(2 * s), 0); }));
  EXPECT_NEAR(curve.length(), 2, 1e-3);
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round});
  const auto error = error_against(scene.surface, chart, 2, radius, radius / 2, [](const Vec3d& x) {
    return Coordinates{std::atan2(x.y(), x.x()), std::asin(x.z() / x.norm())};
  });
  EXPECT_GT(error.count, 3000);
  EXPECT_LE(error.d_mean, 5e-4);
}

// The stroke goes to the right along the upper side of a hairpin and back along the lower one. Between the
// two sides vertices have both on their right. Far from the bend the sides are two visits, and every vertex
// has the sheets of the sides that it is near.
TEST(StrokeChart, KeepsASheetForEachRunOfAHairpin) {
  Scene scene(test::shuffled(test::plane(1, 0.02, 31), 32));
  const double radius = 0.25;
  const std::vector<Vec3d> hairpin = {{-0.6, 0.2, 0}, {0, 0.2, 0},  {0.4, 0.2, 0},  {0.6, 0, 0},
                                      {0.4, -0.2, 0}, {0, -0.2, 0}, {-0.6, -0.2, 0}};
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, radius, hairpin);
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round});
  std::vector<int> sheets(scene.surface.vertex_count(), 0);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec3f& x = scene.surface.positions[chart.vertex[i]];
    if (x.x() < -0.58F || x.x() > 0.05F) continue;
    const bool upper = chart.t[i] < curve.length() / 2;
    EXPECT_EQ(chart.sheet[i], sheets[chart.vertex[i]]++);
    EXPECT_NEAR(chart.d[i], upper ? x.y() - 0.2F : -0.2F - x.y(), 0.01F) << x.transpose();
    const double along = static_cast<double>(x.x()) + 0.6;
    EXPECT_NEAR(chart.t[i], upper ? along : curve.length() - along, 0.02) << x.transpose();
  }
  int doubled = 0;
  for (Index v = 0; v < scene.surface.vertex_count(); ++v) {
    const Vec3f& x = scene.surface.positions[v];
    const float upper = std::abs(x.y() - 0.2F), lower = std::abs(x.y() + 0.2F);
    if (x.x() < -0.58F || x.x() > 0.05F || std::abs(upper - 0.25F) < 0.01F || std::abs(lower - 0.25F) < 0.01F)
      continue;
    EXPECT_EQ(sheets[v], (upper < 0.25F) + (lower < 0.25F)) << x.transpose();
    doubled += sheets[v] == 2;
  }
  EXPECT_GT(doubled, 100);
}

// Inside a bend tighter than the radius the discs never let go of a vertex, but the stroke goes away from it
// and comes back: both runs have their coordinates there, though their fronts meet.
TEST(StrokeChart, GivesBothRunsOfABendTheirOwnSheet) {
  Scene scene(test::shuffled(test::plane(1, 0.02, 31), 32));
  const double radius = 0.25;
  const std::vector<Vec3d> hairpin = {{-0.6, 0.12, 0}, {0, 0.12, 0},  {0.4, 0.12, 0},  {0.52, 0, 0},
                                      {0.4, -0.12, 0}, {0, -0.12, 0}, {-0.6, -0.12, 0}};
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, radius, hairpin);
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round});
  std::size_t between = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec3f& x = scene.surface.positions[chart.vertex[i]];
    if (x.x() < 0.1F || x.x() > 0.25F || std::abs(x.y()) > 0.08F) continue;
    const bool first_run = chart.t[i] < chart.length / 2;
    float nearest = 1;
    for (const CurvePoint& point : curve.points)
      if ((point.at.position.y() > 0) == first_run)
        nearest = std::min(nearest, (x - point.at.position).norm());
    EXPECT_EQ(chart.sheet[i], first_run ? 0U : 1U);
    EXPECT_NEAR(chart.d[i], -nearest, 0.005F) << x.transpose();
    ++between;
  }
  EXPECT_GT(between, 100U);
}

TEST(StrokeChart, DoesNotGrowBeyondItsWidthWhereOppositeSidesMeet) {
  Scene scene(test::shuffled(test::plane(1, 0.02, 31), 32));
  const double radius = 0.25;
  // An S whose middle run has the left of one neighbour and the right of the other beside it.
  const std::vector<Vec3d> s_curve = {{-0.5, 0.4, 0},  {0, 0.4, 0},   {0.4, 0.4, 0}, {0.55, 0.2, 0},
                                      {0.4, 0, 0},     {0, 0, 0},     {-0.4, 0, 0},  {-0.55, -0.2, 0},
                                      {-0.4, -0.4, 0}, {0.5, -0.4, 0}};
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, radius, s_curve);
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round});
  ASSERT_GT(chart.size(), 2000U);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec3f& x = scene.surface.positions[chart.vertex[i]];
    double nearest = 1;
    for (const CurvePoint& point : curve.points) {
      nearest = std::min(nearest, static_cast<double>((x - point.at.position).norm()));
    }
    EXPECT_LE(nearest, 1.05 * radius) << x.transpose();
  }
}

TEST(StrokeChart, IsADiscAroundASinglePoint) {
  Scene scene(test::plane(1, 0.02, 4));
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, 0.2, {{0.1, 0.1, 0}});
  ASSERT_EQ(curve.points.size(), 1U);
  const Chart chart = scene.builder.chart(curve, {0.2, Cap::round});
  EXPECT_GT(chart.size(), 280U);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const float distance = (scene.surface.positions[chart.vertex[i]] - Vec3f(0.1F, 0.1F, 0)).norm();
    EXPECT_NEAR(std::hypot(chart.t[i], static_cast<double>(chart.d[i])), distance, 1e-5);
  }
}

/// Draws samples one by one; after each the extended chart must be the one computed afresh.
void expect_extension_equals_fresh_charts(Scene& scene, const std::vector<Vec3d>& samples, double radius) {
  StrokeChartBuilder fresh(scene.surface);
  CurveTracer tracer(scene.surface, scene.picker, radius);
  std::size_t extended = 0;
  for (const Vec3d& sample : samples) {
    const auto at = scene.picker.closest(sample.cast<float>(), static_cast<float>(radius));
    ASSERT_TRUE(at.has_value());
    const bool first = tracer.curve().points.empty();
    tracer.add(*at, 0, {});
    const Chart chart = first ? scene.builder.chart(tracer.curve(), {radius, Cap::round})
                              : scene.builder.extend(tracer.curve());
    test::expect_same(chart, fresh.chart(tracer.curve(), {radius, Cap::round}));
    if (testing::Test::HasFailure()) FAIL() << "after sample " << extended;
    ++extended;
  }
  EXPECT_GT(extended, 20U);
}

TEST(StrokeChart, ExtendsToTheChartOfTheWholeCurve) {
  Scene scene(test::shuffled(test::sphere(5, 0.2, 41), 42));
  expect_extension_equals_fresh_charts(
      scene,
      sampled(40,
              [](double s) {
                return Vec3d(std::cos(2 * s), std::sin(2 * s), 0.4 * std::sin(9 * s)).normalized();
              }),
      0.25);
}

// Crossing itself, turning back on itself, standing still: seeds and fronts of old parts give way to new
// ones.
TEST(StrokeChart, ExtendsAcrossItself) {
  Scene scene(test::shuffled(test::plane(1, 0.04, 43), 44));
  std::vector<Vec3d> samples =
      sampled(60, [](double s) { return Vec3d(0.6 * std::sin(12 * s), 0.6 * std::sin(8 * s), 0); });
  for (int i = 0; i < 10; ++i)
    samples.push_back(samples[samples.size() - 2 - 2 * static_cast<std::size_t>(i)]);
  samples.push_back(samples.back());
  expect_extension_equals_fresh_charts(scene, samples, 0.2);
}

// The chart is extended from any curve to any other, so that seeds appear, disappear and change all over the
// surface.
TEST(StrokeChart, ExtendsToAnyOtherCurve) {
  const std::uint32_t seed = 47;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Scene scene(test::shuffled(test::sphere(4, 0.25, 48), 49));
  StrokeChartBuilder fresh(scene.surface);
  const auto uniform = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  std::vector<Vec3d> samples = {Vec3d::UnitX()};
  std::size_t longer = 0, shorter = 0;
  scene.builder.chart(test::traced(scene.surface, scene.picker, 0.3, samples), {0.3, Cap::round});
  for (int i = 0; i < 200; ++i) {
    const std::size_t before = samples.size();
    samples.resize(samples.size() - std::min<std::size_t>(random() % 4, samples.size() - 1));
    for (auto more = random() % 5; more > 0; --more) {
      samples.push_back((samples.back() + 0.4 * Vec3d(uniform(), uniform(), uniform())).normalized());
    }
    longer += samples.size() > before;
    shorter += samples.size() < before;
    const SurfaceCurve curve = test::traced(scene.surface, scene.picker, 0.3, samples);
    test::expect_same(scene.builder.extend(curve), fresh.chart(curve, {0.3, Cap::round}));
    if (HasFailure()) FAIL() << "at curve " << i;
  }
  EXPECT_GT(longer, 50U);
  EXPECT_GT(shorter, 30U);
}

TEST(StrokeChart, CanBeShortened) {
  Scene scene(test::shuffled(test::plane(1, 0.04, 45), 46));
  const auto line = [&](double length) {
    return test::traced(scene.surface, scene.picker, 0.2,
                        {{-0.7, 0.1, 0}, {-0.7 + length, -0.2 * length, 0}});
  };
  scene.builder.chart(line(1.2), {0.2, Cap::butt});
  const Chart shortened = scene.builder.extend(line(0.5));
  test::expect_same(shortened, StrokeChartBuilder(scene.surface).chart(line(0.5), {0.2, Cap::butt}));
}

TEST(StrokeChart, DependsOnNothingButItsArguments) {
  Scene scene(test::sphere(5, 0.2, 21));
  const auto circle = [&](double height, double radius) {
    return test::traced(scene.surface, scene.picker, radius, sampled(30, [&](double s) {
                          return Vec3d(std::cos(s), std::sin(s), height).normalized();
                        }));
  };
  const SurfaceCurve first = circle(0.1, 0.2), other = circle(-0.4, 0.5);
  const Chart before = scene.builder.chart(first, {0.2, Cap::round});
  scene.builder.chart(other, {0.5, Cap::butt});
  const Chart after = scene.builder.chart(first, {0.2, Cap::round});
  test::expect_same(before, after);
}

// The width falls along the stroke from the whole radius to a quarter of it.
TEST(StrokeChart, IsAsWideAsTheStrokeIsThere) {
  Scene scene(test::shuffled(test::plane(1, 0.01, 51), 52));
  const double radius = 0.2;
  SurfaceCurve curve = test::traced(scene.surface, scene.picker, radius,
                                    sampled(60, [](double s) { return Vec3d(-0.7 + 1.4 * s, 0.003, 0); }));
  for (CurvePoint& point : curve.points)
    point.width = static_cast<float>(1 - 0.75 * point.t / curve.length());
  const Chart chart = scene.builder.chart(curve, {radius, Cap::butt});
  std::vector<bool> held(scene.surface.vertex_count(), false);
  for (const Index v : chart.vertex) held[v] = true;
  std::size_t inside = 0;
  for (Index v = 0; v < scene.surface.vertex_count(); ++v) {
    const Vec3d x = scene.surface.positions[v].cast<double>();
    if (std::abs(x.x()) > 0.69) continue;
    const double outside = std::abs(x.y() - 0.003) - radius * (1 - 0.75 * (x.x() + 0.7) / 1.4);
    if (std::abs(outside) < 1e-4) continue;
    EXPECT_EQ(held[v], outside < 0) << x.transpose();
    inside += outside < 0;
  }
  EXPECT_GT(inside, 3000U);
}

TEST(StrokeChart, RefusesWhatIsNoStroke) {
  Scene scene(test::plane(1, 0.5, 1));
  const SurfaceCurve curve = test::traced(scene.surface, scene.picker, 0.2, {{0, 0, 0}});
  EXPECT_THROW(scene.builder.extend(curve), ContractError);
  EXPECT_THROW(scene.builder.chart(curve, {0, Cap::round}), ContractError);
  EXPECT_THROW(scene.builder.chart(curve, {std::numeric_limits<double>::infinity(), Cap::round}),
               ContractError);
  EXPECT_THROW(scene.builder.chart({}, {1, Cap::round}), ContractError);
}

}  // namespace
}  // namespace burin
