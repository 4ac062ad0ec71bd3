// Charts strokes in legs as they grow, and closed ones, on a plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>

#include "support/charted.h"
#include "support/closed_curve.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double leg_radius = 0.2, leg_edge = 0.01;

TriangleMesh ground() { return test::shuffled(test::plane(1, leg_edge, 5), 6); }

/// Once around the square with the corners (+-0.4, +-0.4), counterclockwise from the middle of a side:
/// number 0 is the lower one.
SurfaceCurve square(const test::Charted& scene, int side) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 320; ++i) {
    const double s = static_cast<double>(i) / 80 + side + 0.5, along = 0.8 * (s - std::floor(s)) - 0.4;
    const int at = static_cast<int>(std::floor(s)) % 4;
    const Vec2d x = at == 0   ? Vec2d(along, -0.4)
                    : at == 1 ? Vec2d(0.4, along)
                    : at == 2 ? Vec2d(-along, 0.4)
                              : Vec2d(-0.4, -along);
    samples.emplace_back(x.x(), x.y(), 0);
  }
  SurfaceCurve curve = test::traced(scene.surface, scene.picker, leg_radius, samples);
  test::close(curve);
  return curve;
}

class ClosedJoins : public testing::TestWithParam<Join> {};

// Where a closed stroke begins makes no difference but to t, by what the beginning moved.
TEST_P(ClosedJoins, DoNotDependOnTheBeginning) {
  test::Charted scene(ground());
  const ChartOptions options{.radius = leg_radius, .join = GetParam()};
  std::map<Index, std::pair<double, double>> first;
  const Chart chart = scene.builder.chart(square(scene, 0), options);
  for (std::size_t i = 0; i < chart.size(); ++i)
    first[chart.vertex[i]] = {chart.t[i], static_cast<double>(chart.d[i])};
  for (const int side : {1, 2, 3}) {
    const Chart other = scene.builder.chart(square(scene, side), options);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < other.size(); ++i) {
      const Vec2d x = scene.surface.positions[other.vertex[i]].head<2>().cast<double>();
      const double off_diagonal = std::abs(std::abs(x.x()) - std::abs(x.y())) / std::sqrt(2.);
      if (off_diagonal < 2 * leg_edge || std::abs(std::abs(other.d[i]) - leg_radius) < leg_edge) continue;
      const auto at = first.find(other.vertex[i]);
      ASSERT_NE(at, first.end()) << x.transpose();
      const double ways = other.t[i] + 0.8 * side - at->second.first;
      EXPECT_NEAR(std::remainder(ways, 3.2), 0, 0.06 * leg_radius) << x.transpose();
      EXPECT_NEAR(static_cast<double>(other.d[i]), at->second.second, 0.03 * leg_radius) << x.transpose();
      ++compared;
    }
    EXPECT_GT(compared, 8000U);
  }
}

INSTANTIATE_TEST_SUITE_P(Closed, ClosedJoins, testing::Values(Join::smooth, Join::miter),
                         [](const auto& joined) { return std::string(name_of(named_joins, joined.param)); });

/// What each event of a growing stroke cost: nodes settled by fronts, and nodes of vertices computed.
std::vector<std::size_t> costs_of_events(const ChartOptions& options, const std::vector<Vec3d>& samples) {
  test::Charted scene(ground());
  scene.builder.begin(options);
  const CurveGround ground(scene.surface, scene.picker, scene.builder.base());
  CurveTracer tracer(ground, options.radius);
  std::vector<std::size_t> costs;
  for (const Vec3d& sample : samples) {
    const auto at = scene.picker.closest(sample.cast<float>(), 0.1F);
    const std::size_t unchanged = tracer.final_points();
    tracer.add(*at, static_cast<double>(costs.size()) / 240, {});
    const std::size_t computed = scene.builder.draw(tracer.curve(), unchanged).computed().size();
    costs.push_back(scene.builder.settled() + computed);
  }
  return costs;
}

class GrowingJoins : public testing::TestWithParam<Join> {};

// Lines to and fro with right angles between them: what an event costs does not depend on how much was drawn.
TEST_P(GrowingJoins, CostTheSameHoweverLongTheStrokeIs) {
  constexpr int rows = 12, steps = 50;
  const double small = 0.05;
  std::vector<Vec3d> samples;
  for (int i = 0; i < rows * steps; ++i) {
    const double along = static_cast<double>(i % steps) / steps, y = -0.8 + 0.13 * (i / steps);
    const double x = 0.8 * std::clamp(2.2 * along - 1, -1., 1.), rise = 0.13 * std::max(0., 12 * along - 11);
    samples.emplace_back(i / steps % 2 == 0 ? x : -x, y + rise, 0);
  }
  for (const double follow : {0., 1.}) {
    const auto costs = costs_of_events({.radius = small, .join = GetParam(), .follow = follow}, samples);
    const auto sum = [&](int from, int to) {
      return std::accumulate(costs.begin() + from * steps, costs.begin() + to * steps, std::size_t{0});
    };
    const std::size_t early = sum(2, 4), late = sum(rows - 2, rows);
    std::cout << "follow " << follow << ": " << early << " in the third and fourth row, " << late
              << " in the last two\n";
    EXPECT_GT(early, 10'000U);
    EXPECT_LT(static_cast<double>(late), 1.15 * static_cast<double>(early));
  }
}

INSTANTIATE_TEST_SUITE_P(Growing, GrowingJoins, testing::Values(Join::smooth, Join::miter, Join::overlap),
                         [](const auto& joined) { return std::string(name_of(named_joins, joined.param)); });

}  // namespace
}  // namespace burin
