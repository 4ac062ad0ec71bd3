// The chart against geodesic shooting on analytic surfaces with curvature of both signs: shuffled, jittered
// triangulations with random diagonals, away from the ends, in percent of the radius.
#include <burin/chart/stroke_chart.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "support/shapes.h"
#include "support/shooting.h"
#include "support/traced.h"

namespace burin {
namespace {

constexpr double radius = 0.3;

using test::Height;
using test::PlaneCurve;

Height egg_crate(double x, double y) {
  const double a = 0.12, p = 3, q = 2.5, sx = std::sin(p * x), cx = std::cos(p * x);
  const double sy = std::sin(q * y + 0.4), cy = std::cos(q * y + 0.4);
  return {a * sx * sy,          a * p * cx * sy,     a * q * sx * cy,
          -a * p * p * sx * sy, a * p * q * cx * cy, -a * q * q * sx * sy};
}

Height hill_on_saddle(double x, double y) {
  const double e = 0.3 * std::exp(-3 * (x * x + y * y));
  return {0.3 * (x * x - y * y) + e,    0.6 * x - 6 * x * e, -0.6 * y - 6 * y * e,
          0.6 - 6 * e + 36 * x * x * e, 36 * x * y * e,      -0.6 - 6 * e + 36 * y * y * e};
}

/// Errors of one coordinate, percent of the radius.
struct Errors {
  std::vector<double> sorted;

  double mean() const {
    return std::accumulate(sorted.begin(), sorted.end(), 0.) / static_cast<double>(sorted.size());
  }
  double p99() const { return sorted[sorted.size() * 99 / 100]; }
};

struct ChartErrors {
  Errors t, d;
};

class Shooting : public testing::TestWithParam<Height (*)(double, double)> {
 protected:
  /// An S-shaped stroke that turns both ways across a triangulation with edges of about this length.
  ChartErrors errors(double edge, const ChartOptions& options) const {
    const PlaneCurve curve{[](double s) { return Vec2d(-0.8 + 1.6 * s, 0.25 * std::sin(3.5 * s - 1)); },
                           [](double s) { return Vec2d(1.6, 0.875 * std::cos(3.5 * s - 1)); }};
    const test::ShootingOracle oracle(GetParam(), curve);
    const int cells = static_cast<int>(std::lround(2.6 / edge));
    const Surface surface = make_surface(
        test::shuffled(test::patch({.u_min = -1.3,
                                    .u_max = 1.3,
                                    .v_min = -1.3,
                                    .v_max = 1.3,
                                    .cells_u = cells,
                                    .cells_v = cells,
                                    .seed = 7},
                                   [](double x, double y) { return Vec3d(x, y, GetParam()(x, y).f); }),
                       3));
    const Picker picker(surface);
    std::vector<Vec3d> samples;
    for (int i = 0; i < 200; ++i) samples.push_back(oracle.place(i / 199.));
    const SurfaceLevels levels(surface);
    StrokeCharter charter(surface, &levels);
    charter.begin(options);
    EXPECT_EQ(charter.base() != nullptr, options.follow < 1);
    const CurveGround ground(surface, picker, charter.base());
    const Chart chart = charter.draw(test::traced(ground, picker, radius, samples)).sorted();
    return compare(surface, chart, oracle);
  }

 private:
  static ChartErrors compare(const Surface& surface, const Chart& chart, const test::ShootingOracle& oracle) {
    ChartErrors errors;
    const std::size_t stride = std::max<std::size_t>(1, chart.size() / 2000);
    std::size_t unsolved = 0;
    for (std::size_t i = 0; i < chart.size(); i += stride) {
      const Vec3f& x = surface.positions[chart.vertex[i]];
      const auto exact = oracle.solve({x.x(), x.y()}, {chart.t[i], chart.d[i]});
      if (!exact) {
        ++unsolved;
      } else if (exact->t > radius / 3 && exact->t < oracle.length() - radius / 3) {
        errors.t.sorted.push_back(100 / radius * std::abs(chart.t[i] - exact->t));
        errors.d.sorted.push_back(100 / radius * std::abs(static_cast<double>(chart.d[i]) - exact->d));
      }
    }
    EXPECT_EQ(unsolved, 0U);
    EXPECT_GT(errors.t.sorted.size(), 500U);
    std::ranges::sort(errors.t.sorted);
    std::ranges::sort(errors.d.sorted);
    return errors;
  }
};

TEST_P(Shooting, SecondOrderIsWithinItsBounds) {
  const ChartErrors second = errors(radius / 20, {.radius = radius});
  EXPECT_LE(second.d.mean(), 0.002);
  EXPECT_LE(second.d.p99(), 0.01);
  EXPECT_LE(second.t.mean(), 0.02);
  EXPECT_LE(second.t.p99(), 0.1);
  RecordProperty("d_mean", std::to_string(second.d.mean()));
  RecordProperty("t_mean", std::to_string(second.t.mean()));
}

// At the brush's own scale: a chart of the base surface, carried to the vertices.
TEST_P(Shooting, ChartsOfTheBaseSurfaceAreWithinTheirBounds) {
  for (const auto& [edges, d_p99] : {std::pair(20, 0.03), {40, 0.035}}) {
    const ChartErrors carried = errors(radius / edges, {.radius = radius, .follow = 0});
    EXPECT_LE(carried.d.mean(), 0.005) << edges << " edges a radius";
    EXPECT_LE(carried.d.p99(), d_p99) << edges << " edges a radius";
    EXPECT_LE(carried.t.mean(), 0.03) << edges << " edges a radius";
    EXPECT_LE(carried.t.p99(), 0.12) << edges << " edges a radius";
  }
}

TEST_P(Shooting, SecondOrderIsFarBetterThanFirst) {
  const ChartErrors first = errors(radius / 20, {.radius = radius, .order = 1}),
                    second = errors(radius / 20, {.radius = radius});
  EXPECT_LE(second.d.mean(), first.d.mean() / 20);
  EXPECT_LE(second.t.mean(), first.t.mean() / 10);
  EXPECT_LE(second.d.sorted.back(), first.d.sorted.back());
  EXPECT_LE(second.t.sorted.back(), first.t.sorted.back());
}

TEST_P(Shooting, HalvingTheEdgeHalvesTheMeanErrors) {
  ChartErrors coarse = errors(radius / 8, {.radius = radius});
  for (const int edges : {16, 32, 64}) {
    const ChartErrors fine = errors(radius / edges, {.radius = radius});
    EXPECT_LE(fine.d.mean(), coarse.d.mean() / 2) << edges << " edges a radius";
    EXPECT_LE(fine.t.mean(), coarse.t.mean() / 2) << edges << " edges a radius";
    coarse = fine;
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Shooting, testing::Values(&egg_crate, &hill_on_saddle));

}  // namespace
}  // namespace burin
