// Tests charts over base surfaces where the scale changes: radii at which the level changes, a width that
// varies along the stroke, and strokes that are much longer than their radius.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shooting_errors.h"
#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

TriangleMesh square_of(const test::HeightField& field, double edge) {
  const int cells = static_cast<int>(std::lround(2.6 / edge));
  return test::shuffled(
      test::patch(
          {.u_min = -1.3, .u_max = 1.3, .v_min = -1.3, .v_max = 1.3, .cells_u = cells, .cells_v = cells},
          [&](double x, double y) { return Vec3d(x, y, field(x, y).f); }),
      3);
}

class BaseRadii : public testing::TestWithParam<test::Height (*)(double, double)> {};

// Radii range from the least of one level to the greatest of the next. Small radii bend less with the
// surface.
TEST_P(BaseRadii, GiveExactCoordinatesOnEveryLevel) {
  const test::ShootingOracle oracle(GetParam(), test::s_curve());
  const auto samples = test::sampled(200, [&](double s) { return oracle.place(s); });
  test::Charted on(square_of(GetParam(), 0.012));
  std::size_t levels = 0;
  double spacing = 0;
  for (double radius = 0.085; radius < 0.31; radius *= 1.2) {
    const Chart chart = on.chart({.radius = radius, .follow = 0}, samples);
    ASSERT_NE(on.builder.base(), nullptr);
    if (on.builder.base()->spacing() != spacing) ++levels;
    spacing = on.builder.base()->spacing();
    const test::ChartErrors errors = test::errors_of(chart, oracle, radius, [&](Index vertex) {
      const Vec3f& at = on.surface.positions[vertex];
      return Vec2d(at.x(), at.y());
    });
    EXPECT_LE(errors.t.mean(), 0.03) << "radius " << radius << ", " << radius / spacing << " spacings";
    EXPECT_LE(errors.d.mean(), 0.005) << "radius " << radius << ", " << radius / spacing << " spacings";
    EXPECT_LE(errors.t.p99(), 0.15) << "radius " << radius << ", " << radius / spacing << " spacings";
    EXPECT_LE(errors.d.p99(), 0.05) << "radius " << radius << ", " << radius / spacing << " spacings";
  }
  EXPECT_GE(levels, 2U);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, BaseRadii,
                         testing::Values(&test::shallow_egg_crate, &test::hill_on_saddle));

// No coordinate knows how wide the stroke is elsewhere.
TEST(BaseWidths, VaryWithoutASeam) {
  constexpr double radius = 0.3;
  const test::ShootingOracle oracle(&test::shallow_egg_crate, test::s_curve());
  const auto samples = test::sampled(200, [&](double s) { return oracle.place(s); });
  test::Charted on(square_of(&test::shallow_egg_crate, radius / 20));
  const ChartOptions options{.radius = radius, .follow = 0};
  const Chart even = on.chart(options, samples);
  std::vector<std::size_t> node_of(on.surface.vertex_count(), even.size());
  for (std::size_t i = 0; i < even.size(); ++i) node_of[even.vertex[i]] = i;
  SurfaceCurve curve = on.curve;
  const auto width = [&](double t) {
    return 0.1 + 0.9 * std::pow(std::cos(2 * std::numbers::pi * t / curve.length()), 2);
  };
  for (CurvePoint& point : curve.points) point.width = static_cast<float>(width(point.t));
  const Chart varying = on.builder.chart(curve, options);
  std::size_t inside = 0, compared = 0;
  for (std::size_t i = 0; i < even.size(); ++i)
    if (even.t[i] > 0.1 && even.t[i] < curve.length() - 0.1)
      inside += std::abs(static_cast<double>(even.d[i])) < 0.99 * radius * width(even.t[i]);
  for (std::size_t i = 0; i < varying.size(); ++i) {
    const std::size_t node = node_of[varying.vertex[i]];
    ASSERT_LT(node, even.size());
    EXPECT_NEAR(varying.t[i], even.t[node], 0.0005 * radius);
    EXPECT_NEAR(varying.d[i], even.d[node], 0.0005 * radius);
    if (varying.t[i] < 0.1 || varying.t[i] > curve.length() - 0.1) continue;
    EXPECT_LE(std::abs(static_cast<double>(varying.d[i])), 1.01 * radius * width(varying.t[i]));
    ++compared;
  }
  EXPECT_GT(inside, 1500U);
  EXPECT_GE(compared, inside);
}

// A spiral of eleven turns: t is the arc length of the pen's way, d the distance to it.
TEST(LongStrokes, StayExact) {
  constexpr double radius = 1, pitch = 2.6 * radius, growth = pitch / (2 * std::numbers::pi);
  constexpr double first = 4, last = 72;  // angles
  const auto place = [](double angle) {
    return Vec3d(growth * angle * std::cos(angle), growth * angle * std::sin(angle), 0);
  };
  const auto length_to = [](double angle) {
    const auto of = [](double a) { return growth / 2 * (a * std::sqrt(1 + a * a) + std::asinh(a)); };
    return of(angle) - of(first);
  };
  ASSERT_GT(length_to(last), 1000 * radius);
  std::vector<Vec3d> samples;
  for (double angle = first; angle < last; angle += 0.4 * radius / std::hypot(growth, growth * angle))
    samples.push_back(place(angle));
  const double half_width = growth * last + 1.5 * radius;
  test::Charted on(test::shuffled(test::plane(half_width, radius / 6, 4), 5));
  const Chart chart = on.chart({.radius = radius, .follow = 0}, samples);
  ASSERT_NE(on.builder.base(), nullptr);
  double t_sum = 0, d_sum = 0, t_most = 0, d_most = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec3f& at = on.surface.positions[chart.vertex[i]];
    const Vec2d x(at.x(), at.y());
    // The turn whose foot is nearest, then Newton for a foot at right angles.
    const double turn = std::atan2(x.y(), x.x()), whole = 2 * std::numbers::pi;
    double angle = turn + whole * std::round((x.norm() / growth - turn) / whole);
    for (int i2 = 0; i2 < 20; ++i2) {
      const double c = std::cos(angle), s = std::sin(angle);
      const Vec2d p = growth * angle * Vec2d(c, s), along = growth * Vec2d(c - angle * s, s + angle * c);
      angle += (x - p).dot(along) / along.squaredNorm();
    }
    if (angle < first + 0.3 || angle > last - 0.05) continue;
    const double d = growth * angle - x.norm() > 0 ? 1 : -1;
    const double exact_d = d * (x - place(angle).head<2>()).norm();
    const double t = std::abs(chart.t[i] - length_to(angle)),
                 d_error = std::abs(static_cast<double>(chart.d[i]) - exact_d);
    t_sum += t;
    d_sum += d_error;
    t_most = std::max(t_most, t);
    d_most = std::max(d_most, d_error);
    ++count;
  }
  ASSERT_GT(count, 50000U);
  EXPECT_LE(t_sum / static_cast<double>(count), 0.0005 * radius);
  EXPECT_LE(d_sum / static_cast<double>(count), 0.0005 * radius);
  EXPECT_LE(t_most, 0.01 * radius);
  EXPECT_LE(d_most, 0.01 * radius);
}

}  // namespace
}  // namespace burin
