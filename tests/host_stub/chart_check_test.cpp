#include "chart_check.h"

#include <burin/chart/stroke_chart.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/charted.h"
#include "support/shapes.h"

namespace burin::command {
namespace {

constexpr double radius = 0.2;

std::vector<Vec3d> bow(double height) {
  return test::sampled(40, [=](double s) { return Vec3d(1.2 * (s - 0.5), 0.2 * std::sin(3 * s), height); });
}

std::vector<Vec3d> bow_on_sphere() {
  std::vector<Vec3d> samples = bow(0.8);
  for (Vec3d& sample : samples) sample.normalize();
  return samples;
}

TEST(ChartCheck, FindsNothingWrongOnThePlane) {
  test::Charted on(test::plane(1, 0.02, 3));
  const Chart chart = on.chart({.radius = radius}, bow(0));
  const ChartCheck check = check_chart(on.surface, on.curve, chart, radius);
  EXPECT_GT(check.under_pen, 500U);
  EXPECT_EQ(check.holes, 0U);
  ASSERT_TRUE(check.distances.has_value());
  EXPECT_FALSE(check.distances->sphere);
  EXPECT_LT(check.distances->worst, 0.005);
  EXPECT_GT(check.distances->worst, 0);
}

TEST(ChartCheck, FindsNothingWrongOnTheSphere) {
  test::Charted on(test::sphere(6, 0.1, 3));
  const Chart chart = on.chart({.radius = radius}, bow_on_sphere());
  const ChartCheck check = check_chart(on.surface, on.curve, chart, radius);
  EXPECT_EQ(check.holes, 0U);
  ASSERT_TRUE(check.distances.has_value());
  EXPECT_TRUE(check.distances->sphere);
  EXPECT_LT(check.distances->worst, 0.005);
}

TEST(ChartCheck, CountsNodesThatAreMissingOrWrong) {
  test::Charted on(test::plane(1, 0.02, 3));
  Chart chart = on.chart({.radius = radius}, bow(0));
  std::size_t taken = 0, moved = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    if (std::abs(chart.d[i]) > 0.3 * radius) continue;
    if (i % 50 == 0) {
      chart.vertex[i] = no_index;
      ++taken;
    } else if (i % 50 == 1) {
      chart.d[i] += static_cast<float>(std::copysign(0.3 * radius, chart.d[i]));
      ++moved;
    }
  }
  ASSERT_GT(taken, 3U);
  const ChartCheck check = check_chart(on.surface, on.curve, chart, radius);
  EXPECT_EQ(check.holes, taken);
  EXPECT_EQ(check.distances->off_2, moved);
  EXPECT_EQ(check.distances->off_10, moved);
  EXPECT_NEAR(check.distances->worst, 0.3, 0.01);
}

TEST(ChartCheck, KnowsNoDistancesOnOtherSurfaces) {
  test::Charted on(
      test::patch({.u_min = -1, .u_max = 1, .v_min = -1, .v_max = 1, .cells_u = 100, .cells_v = 100},
                  [](double u, double v) { return Vec3d(u, v, 0.2 * u * v); }));
  const Chart chart = on.chart({.radius = radius}, bow(0));
  const ChartCheck check = check_chart(on.surface, on.curve, chart, radius);
  EXPECT_EQ(check.holes, 0U);
  EXPECT_FALSE(check.distances.has_value());
}

}  // namespace
}  // namespace burin::command
