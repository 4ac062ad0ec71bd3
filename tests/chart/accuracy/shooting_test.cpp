// Compares charts with geodesic shooting on analytic surfaces with curvature of both signs. Triangulations
// are shuffled and jittered, with random diagonals. Errors are in percent of the radius, away from the
// ends.
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "shooting_errors.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

constexpr double smooth_radius = 0.3;

using test::ChartErrors;
using test::Height;

class Shooting : public testing::TestWithParam<Height (*)(double, double)> {
 protected:
  /// A stroke across a triangulation with edges of about this length.
  ChartErrors errors(double edge, const ChartOptions& options) const {
    const test::ShootingOracle oracle(GetParam(), test::s_curve());
    const int cells = static_cast<int>(std::lround(2.6 / edge));
    const Surface surface = make_surface(test::field_mesh(GetParam(), cells));
    const Picker picker(surface);
    std::vector<Vec3d> samples;
    for (int i = 0; i < 200; ++i) samples.push_back(oracle.place(i / 199.));
    const SurfaceLevels levels(surface);
    StrokeChartBuilder builder(surface, &levels);
    builder.begin(options);
    EXPECT_EQ(builder.base() != nullptr, options.follow < 1);
    const CurveGround ground(surface, picker, builder.base());
    const Chart chart = builder.draw(test::traced(ground, picker, smooth_radius, samples)).sorted();
    return test::errors_of(chart, oracle, smooth_radius, [&](Index vertex) {
      const Vec3f& x = surface.positions[vertex];
      return Vec2d(x.x(), x.y());
    });
  }
};

TEST_P(Shooting, SecondOrderIsWithinItsBounds) {
  const ChartErrors second = errors(smooth_radius / 20, {.radius = smooth_radius});
  EXPECT_LE(second.d.mean(), 0.002);
  EXPECT_LE(second.d.p99(), 0.01);
  EXPECT_LE(second.t.mean(), 0.02);
  EXPECT_LE(second.t.p99(), 0.1);
  RecordProperty("d_mean", std::to_string(second.d.mean()));
  RecordProperty("t_mean", std::to_string(second.t.mean()));
}

// Charts over the base surface, interpolated to the vertices, have errors within their bounds.
TEST_P(Shooting, ChartsOfTheBaseSurfaceAreWithinTheirBounds) {
  for (const int edges : {16, 20, 34, 40}) {
    const ChartErrors carried = errors(smooth_radius / edges, {.radius = smooth_radius, .follow = 0});
    EXPECT_LE(carried.d.mean(), 0.005) << edges << " edges a radius";
    EXPECT_LE(carried.d.p99(), 0.03) << edges << " edges a radius";
    EXPECT_LE(carried.t.mean(), 0.03) << edges << " edges a radius";
    EXPECT_LE(carried.t.p99(), 0.12) << edges << " edges a radius";
  }
}

TEST_P(Shooting, SecondOrderIsFarBetterThanFirst) {
  const ChartErrors first = errors(smooth_radius / 20, {.radius = smooth_radius, .order = 1}),
                    second = errors(smooth_radius / 20, {.radius = smooth_radius});
  EXPECT_LE(second.d.mean(), first.d.mean() / 20);
  EXPECT_LE(second.t.mean(), first.t.mean() / 10);
  EXPECT_LE(second.d.sorted.back(), first.d.sorted.back());
  EXPECT_LE(second.t.sorted.back(), first.t.sorted.back());
}

TEST_P(Shooting, HalvingTheEdgeHalvesTheMeanErrors) {
  ChartErrors coarse = errors(smooth_radius / 8, {.radius = smooth_radius});
  for (const int edges : {16, 32, 64}) {
    const ChartErrors fine = errors(smooth_radius / edges, {.radius = smooth_radius});
    EXPECT_LE(fine.d.mean(), coarse.d.mean() / 2) << edges << " edges a radius";
    EXPECT_LE(fine.t.mean(), coarse.t.mean() / 2) << edges << " edges a radius";
    coarse = fine;
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Shooting,
                         testing::Values(&test::shallow_egg_crate, &test::hill_on_saddle));

}  // namespace
}  // namespace burin
