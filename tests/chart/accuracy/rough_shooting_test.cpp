// Compares charts over base surfaces with geodesic shooting on rough analytic surfaces: the exact
// coordinates of a vertex are those of its foot point on the smooth surface. Errors are in percent of the
// radius, which spans 20 edges, away from the ends.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "shooting_errors.h"
#include "support/charted.h"
#include "support/relief.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double rough_radius = 0.3, edge = rough_radius / 20;

/// The height of a vertex over the smooth surface at (x, y), object units.
using Roughness = std::function<double(double x, double y)>;

/// An egg crate of six radii, whose crests bend like a ball of 2.3 radii.
test::Height six_radii(double x, double y) {
  const double k = 2 * std::numbers::pi / (6 * rough_radius), a = 0.4 * rough_radius;
  const double sx = std::sin(k * x), cx = std::cos(k * x), sy = std::sin(k * y), cy = std::cos(k * y);
  return {a * sx * sy,          a * k * cx * sy,     a * k * sx * cy,
          -a * k * k * sx * sy, a * k * k * cx * cy, -a * k * k * sx * sy};
}

test::ChartErrors errors(const test::HeightField& field, const Roughness& roughness, double follow) {
  const int cells = static_cast<int>(std::lround(2.6 / edge));
  TriangleMesh mesh = test::shuffled(
      test::patch(
          {.u_min = -1.3, .u_max = 1.3, .v_min = -1.3, .v_max = 1.3, .cells_u = cells, .cells_v = cells},
          [](double x, double y) { return Vec3d(x, y, 0); }),
      3);
  const std::vector<Vec3f> feet = mesh.positions;
  for (Vec3f& position : mesh.positions) {
    const double x = position.x(), y = position.y();
    const test::Height at = field(x, y);
    const Vec3d normal = Vec3d(-at.fx, -at.fy, 1).normalized();
    position = (Vec3d(x, y, at.f) + roughness(x, y) * normal).cast<float>();
  }
  test::Charted on(std::move(mesh));
  const test::ShootingOracle oracle(field, test::s_curve());
  std::vector<Ray> pens;  // along the smooth surface's normal
  for (int i = 0; i < 200; ++i) {
    const Vec3d place = oracle.place(i / 199.);
    const test::Height at = field(place.x(), place.y());
    const Vec3d normal = Vec3d(-at.fx, -at.fy, 1).normalized();
    pens.push_back({(place + rough_radius * normal).cast<float>(), (-normal).cast<float>()});
  }
  const Chart chart = on.chart({.radius = rough_radius, .follow = follow}, pens);
  return test::errors_of(chart, oracle, rough_radius, [&](Index vertex) {
    const Vec3f& foot = feet[on.surface.source_vertex[vertex]];
    return Vec2d(foot.x(), foot.y());
  });
}

void record(const std::string& name, const test::ChartErrors& errors) {
  testing::Test::RecordProperty(name + "_d_mean", std::to_string(errors.d.mean()));
  testing::Test::RecordProperty(name + "_d_p99", std::to_string(errors.d.p99()));
  testing::Test::RecordProperty(name + "_t_mean", std::to_string(errors.t.mean()));
  testing::Test::RecordProperty(name + "_t_p99", std::to_string(errors.t.p99()));
}

TEST(RoughShooting, FollowsWavesOfSixRadiiUnderBumps) {
  const auto bumps = [](test::Relief relief) {
    return
        [=](double x, double y) { return 0.05 * rough_radius * relief(x / rough_radius, y / rough_radius); };
  };
  const test::ChartErrors smooth = errors(
      &six_radii, [](double, double) { return 0; }, 0);
  const test::ChartErrors crate = errors(&six_radii, bumps(&test::egg_crate), 0);
  const test::ChartErrors noise = errors(&six_radii, bumps(&test::band_noise), 0);
  record("smooth", smooth);
  record("crate", crate);
  record("noise", noise);
  EXPECT_LE(smooth.d.mean(), 0.02);
  EXPECT_LE(crate.d.mean(), 0.3);
  EXPECT_LE(noise.d.mean(), 0.3);
}

// A scanner's noise: every vertex moves for itself, by 5 % of an edge (standard deviation).
TEST(RoughShooting, HardlyFeelsNoiseOfTheVertices) {
  for (const auto& field : {&test::shallow_egg_crate, &test::hill_on_saddle}) {
    const std::uint32_t seed = 11;
    std::mt19937 random(seed);
    const auto noise = [&](double, double) {
      double sum = -6;
      for (int i = 0; i < 12; ++i) sum += static_cast<double>(random()) / 4294967296.;
      return 0.05 * edge * sum;
    };
    const test::ChartErrors noisy = errors(field, noise, 0);
    record(field == &test::hill_on_saddle ? "hill" : "crate", noisy);
    EXPECT_LE(noisy.t.mean(), 0.3);
    EXPECT_LE(noisy.d.mean(), 0.3);
  }
}

}  // namespace
}  // namespace burin
