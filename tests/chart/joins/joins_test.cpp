// Tests every kind of join at bends sharper than the radius, on a plane, where lengths and angles can be
// computed by hand.
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double radius = 0.2, edge = 0.01;

struct Scene : test::Charted {
  Scene() : Charted(test::shuffled(test::plane(1, edge, 5), 6)) {}

  SurfaceCurve traced(const std::vector<Vec3d>& samples) const {
    return test::traced(surface, picker, radius, samples);
  }

  /// Along the x axis to the origin, there by `turn` to the left, and on; each leg is `run` long.
  static std::vector<Vec3d> corner_samples(double turn, double run) {
    std::vector<Vec3d> samples;
    for (int i = 60; i > 0; --i) samples.emplace_back(-run * i / 60., 0, 0);
    for (int i = 0; i <= 60; ++i)
      samples.emplace_back(run * i / 60. * std::cos(turn), run * i / 60. * std::sin(turn), 0);
    return samples;
  }
  SurfaceCurve corner(double turn, double run = 0.9) const { return traced(corner_samples(turn, run)); }
};

/// A triangle whose corners all have a node of the same sheet, with what t and d do across it.
struct ChartTriangle {
  Vec2d middle;
  Vec2d grad_t;
  double flip;   ///< Jacobian determinant of (t, d)
  Vec2d spread;  ///< of t and of d over the corners
};

/// Each node of the first corner with the nodes of the others that come closest to it in (t, d).
std::vector<ChartTriangle> triangles_of(const Surface& surface, const Chart& chart) {
  std::multimap<Index, std::size_t> nodes;
  for (std::size_t i = 0; i < chart.size(); ++i) nodes.emplace(chart.vertex[i], i);
  const auto closest = [&](Index vertex, std::size_t to) {
    const auto away = [&](std::size_t i) {
      return std::hypot(chart.t[i] - chart.t[to], static_cast<double>(chart.d[i] - chart.d[to]));
    };
    const auto [first, last] = nodes.equal_range(vertex);
    return std::min_element(first, last,
                            [&](const auto& x, const auto& y) { return away(x.second) < away(y.second); })
        ->second;
  };
  std::vector<ChartTriangle> result;
  for (const Triangle& corners : surface.triangles) {
    if (!nodes.contains(corners[1]) || !nodes.contains(corners[2])) continue;
    const auto at = [&](int i) { return Vec2d(surface.positions[corners[i]].head<2>().cast<double>()); };
    Eigen::Matrix2d edges, changes;
    edges << at(1) - at(0), at(2) - at(0);
    const auto [first, last] = nodes.equal_range(corners[0]);
    for (auto node = first; node != last; ++node) {
      const std::size_t a = node->second, b = closest(corners[1], a), c = closest(corners[2], a);
      changes << chart.t[b] - chart.t[a], chart.t[c] - chart.t[a],
          static_cast<double>(chart.d[b] - chart.d[a]), static_cast<double>(chart.d[c] - chart.d[a]);
      const Eigen::Matrix2d jacobian = changes * edges.inverse();
      const auto [low, high] = std::minmax({chart.t[a], chart.t[b], chart.t[c]});
      const auto [right, left] = std::minmax({chart.d[a], chart.d[b], chart.d[c]});
      result.push_back({(at(0) + at(1) + at(2)) / 3,
                        jacobian.row(0).transpose(),
                        jacobian.determinant(),
                        {high - low, static_cast<double>(left - right)}});
    }
  }
  return result;
}

/// Expects that a triangle is not flipped and that |grad t| is moderate.
void expect_sound(const ChartTriangle& triangle) {
  EXPECT_GT(triangle.flip, 0) << triangle.middle.transpose();
  EXPECT_GE(triangle.grad_t.norm(), 0.5) << triangle.middle.transpose();
  EXPECT_LE(triangle.grad_t.norm(), 2) << triangle.middle.transpose();
}

/// Distance from the bisector of the corner, and which side of it, inner or outer, the point lies on.
struct Place {
  double off_bisector;
  bool inner;
};
Place place_of(const Vec2d& x, double turn) {
  // Inwards the bisector runs halfway between the left normals of the legs.
  const Vec2d inwards = (turn > 0 ? 1 : -1) * Vec2d(-std::sin(turn / 2), std::cos(turn / 2));
  return {std::abs(x.x() * inwards.y() - x.y() * inwards.x()), x.dot(inwards) > 0};
}

class Joins : public testing::TestWithParam<double> {};

TEST_P(Joins, SmoothKeepsTContinuousAndItsGradientBounded) {
  const double turn = GetParam() * std::numbers::pi / 180;
  Scene scene;
  const SurfaceCurve curve = scene.corner(turn);
  const Chart chart = scene.builder.chart(curve, {.radius = radius, .join = Join::smooth});
  std::size_t checked = 0;
  for (const ChartTriangle& triangle : triangles_of(scene.surface, chart)) {
    const auto [off, inner] = place_of(triangle.middle, turn);
    if (inner && off < 3 * edge) {  // the medial wedge: t goes on across it without a jump
      EXPECT_LT(triangle.spread.x(), 5 * edge) << triangle.middle.transpose();
      continue;
    }
    if (triangle.middle.norm() > 0.8 || triangle.middle.norm() < 2 * edge) continue;
    expect_sound(triangle);
    ++checked;
  }
  EXPECT_GT(checked, 3000U);
}

TEST_P(Joins, MiterHasTheStraightCoordinatesOfTheLegs) {
  const double turn = GetParam() * std::numbers::pi / 180;
  Scene scene;
  const SurfaceCurve curve = scene.corner(turn);
  const Chart chart = scene.builder.chart(curve, {.radius = radius, .join = Join::miter});
  const double corner = curve.length() / 2;
  std::size_t outer = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec2d x = scene.surface.positions[chart.vertex[i]].head<2>().cast<double>();
    const Vec2d along(std::cos(turn), std::sin(turn)), left(-std::sin(turn), std::cos(turn));
    const auto [off, inner] = place_of(x, turn);
    // The samples round the corner a little.
    if (off < 2 * edge || x.norm() < 0.05 || x.norm() > 0.85) continue;
    const bool first = x.dot(Vec2d(1, 0) + along) < 0;
    const Vec2d exact = first ? Vec2d(corner + x.x(), x.y()) : Vec2d(corner + x.dot(along), x.dot(left));
    EXPECT_NEAR(chart.t[i], exact.x(), 0.03 * radius) << x.transpose();
    EXPECT_NEAR(chart.d[i], exact.y(), 0.03 * radius) << x.transpose();
    outer += !inner && x.norm() > radius * 1.02;
  }
  for (const ChartTriangle& triangle : triangles_of(scene.surface, chart)) {
    if (place_of(triangle.middle, turn).off_bisector < 3 * edge || triangle.middle.norm() > 0.8) continue;
    EXPECT_GT(triangle.flip, 0) << triangle.middle.transpose();
    EXPECT_NEAR(triangle.grad_t.norm(), 1, 0.5) << triangle.middle.transpose();
  }
  // The tip of the miter lies beyond the radius: that is what it is for.
  const double tip = radius / std::cos(turn / 2);
  const Vec2d outwards = (turn > 0 ? 1 : -1) * Vec2d(std::sin(turn / 2), -std::cos(turn / 2));
  double farthest = 0;
  for (const Index v : chart.vertex)
    farthest = std::max(farthest, outwards.dot(scene.surface.positions[v].head<2>().cast<double>()));
  EXPECT_NEAR(farthest, tip, 2 * edge);
  EXPECT_GT(outer, 10U);
}

TEST_P(Joins, OverlapGivesEachLegItsOwnSheet) {
  const double turn = GetParam() * std::numbers::pi / 180;
  Scene scene;
  const SurfaceCurve curve = scene.corner(turn);
  const Chart chart = scene.builder.chart(curve, {.radius = radius, .join = Join::overlap});
  std::size_t doubled = 0;
  for (const std::uint32_t sheet : chart.sheet) doubled += sheet > 0;
  // Both legs reach the kite inside the bend whose sides are perpendicular to the legs and as long as the
  // radius, but for what the bend takes up.
  EXPECT_GT(static_cast<double>(doubled) * edge * edge, 0.6 * radius * radius * std::tan(std::abs(turn) / 2));
  const Vec2d along(std::cos(turn), std::sin(turn));
  for (const ChartTriangle& triangle : triangles_of(scene.surface, chart)) {
    if (triangle.spread.maxCoeff() > 5 * edge) continue;  // at the border of a sheet, to another
    if (triangle.middle.norm() < 0.4 * radius) continue;
    // Outside of the bend, beyond the ends of both legs, t hardly changes.
    if (std::min(triangle.middle.x(), -triangle.middle.dot(along)) > -5 * edge) continue;
    expect_sound(triangle);
  }
}

TEST_P(Joins, RoundIsTheDistanceToTheStroke) {
  const double turn = GetParam() * std::numbers::pi / 180;
  Scene scene;
  const SurfaceCurve curve = scene.corner(turn);
  const Chart chart = scene.builder.chart(curve, {.radius = radius});
  double worst = 0, mean = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec3f& x = scene.surface.positions[chart.vertex[i]];
    float nearest = 1, told = std::abs(chart.d[i]);
    for (const CurvePoint& point : curve.points) nearest = std::min(nearest, (x - point.at.position).norm());
    for (std::size_t j = 0; j < chart.size(); ++j)
      if (chart.vertex[j] == chart.vertex[i]) told = std::min(told, std::abs(chart.d[j]));
    const auto [off, inner] = place_of(x.head<2>().cast<double>(), turn);
    if (chart.t[i] < 0 || chart.t[i] > curve.length() || (inner && off < 5 * edge)) continue;
    const double error = std::abs(told - nearest) / radius;
    worst = std::max(worst, error);
    mean += error / static_cast<double>(chart.size());
  }
  EXPECT_LE(mean, 0.003);
  EXPECT_LE(worst, 0.05);
}

/// The largest differences of t and d, in radii, between nodes of two charts of a corner, away from the
/// bisector and from the rim.
struct Differences {
  double t = 0, d = 0;
  std::size_t compared = 0;
};

Differences compare(const Scene& scene, const Chart& a, const Chart& b, double turn) {
  std::map<Index, std::size_t> of_b;
  for (std::size_t i = 0; i < b.size(); ++i) of_b[b.vertex[i]] = i;
  Differences most;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2d x = scene.surface.positions[a.vertex[i]].head<2>().cast<double>();
    const bool at_rim = static_cast<double>(std::abs(a.d[i])) > radius - edge;
    if (place_of(x, turn).off_bisector < edge || at_rim || x.norm() > 0.8) continue;
    const auto found = of_b.find(a.vertex[i]);
    if (found == of_b.end()) return {1e9, 1e9, 0};
    most.t = std::max(most.t, std::abs(a.t[i] - b.t[found->second]) / radius);
    most.d = std::max(most.d, static_cast<double>(std::abs(a.d[i] - b.d[found->second])) / radius);
    ++most.compared;
  }
  return most;
}

// On the plane, a chart on the base surface has the coordinates of one on the vertices themselves. The points
// of the curves differ, and so does the middle of the bend, by up to half of their spacing.
TEST_P(Joins, AreTheSameAtTheBrushesOwnScale) {
  const double turn = GetParam() * std::numbers::pi / 180;
  Scene scene;
  for (const Join join : {Join::smooth, Join::miter}) {
    scene.builder.begin({.radius = radius, .join = join, .follow = 0});
    ASSERT_NE(scene.builder.base(), nullptr);
    const CurveGround base(scene.surface, scene.picker, scene.builder.base());
    const SurfaceCurve on_base = test::traced(base, scene.picker, radius, Scene::corner_samples(turn, 0.9));
    const Chart own = scene.builder.draw(on_base).sorted();
    const Chart fine = scene.builder.chart(scene.corner(turn), {.radius = radius, .join = join});
    const Differences most = compare(scene, own, fine, turn);
    std::cout << name_of(named_joins, join) << ": t " << most.t << ", d " << most.d << " radii, "
              << most.compared << " nodes\n";
    EXPECT_LE(most.t, 0.05) << name_of(named_joins, join);
    EXPECT_LE(most.d, 0.02) << name_of(named_joins, join);
    EXPECT_GT(most.compared, 5000U);
  }
}

class SharpCorners : public testing::TestWithParam<double> {};

// The legs end 1.3 radii from the corner, so that there is no room to take t across the bisector whole.
TEST_P(SharpCorners, SmoothDoesNotSqueezeTOnTheInside) {
  const double turn = GetParam() * std::numbers::pi / 180, run = 1.3 * radius;
  Scene scene;
  const Chart chart = scene.builder.chart(scene.corner(turn, run), {.radius = radius, .join = Join::smooth});
  std::size_t checked = 0;
  double most = 0;
  for (const ChartTriangle& triangle : triangles_of(scene.surface, chart)) {
    const auto [off, inner] = place_of(triangle.middle, turn);
    const double along_first = -triangle.middle.x(),
                 along_second = triangle.middle.dot(Vec2d(std::cos(turn), std::sin(turn)));
    if (!inner || off < 3 * edge || std::max(along_first, along_second) > run - 2 * edge) continue;
    if (triangle.middle.norm() < 4 * edge) continue;  // the samples round the corner a little
    EXPECT_GT(triangle.flip, 0) << triangle.middle.transpose();
    most = std::max(most, triangle.grad_t.norm());
    ++checked;
  }
  EXPECT_LE(most, 2.5);
  EXPECT_GT(checked, 200U);
}

INSTANTIATE_TEST_SUITE_P(Turns, SharpCorners, testing::Values(100., 120., 135., -135.), [](const auto& turn) {
  return (turn.param < 0 ? "Right" : "Left") + std::to_string(std::abs(static_cast<int>(turn.param)));
});

// A hook's legs nearly coincide. A vertex beside both has the node of each.
TEST(Hooks, KeepBothLegsOfASmoothJoin) {
  const double turn = 165 * std::numbers::pi / 180;
  Scene scene;
  const SurfaceCurve curve = scene.corner(turn);
  const Chart chart = scene.builder.chart(curve, {.radius = radius, .join = Join::smooth});
  std::map<Index, std::vector<double>> told;
  for (std::size_t i = 0; i < chart.size(); ++i)
    told[chart.vertex[i]].push_back(std::abs(static_cast<double>(chart.d[i])));
  const Vec2d along(std::cos(turn), std::sin(turn));
  std::size_t checked = 0;
  for (Index vertex = 0; vertex < scene.surface.vertex_count(); ++vertex) {
    const Vec2d x = scene.surface.positions[vertex].head<2>().cast<double>();
    const double first = std::abs(x.y()), second = std::abs(x.x() * along.y() - x.y() * along.x());
    if (std::max(first, second) > 0.95 * radius || -x.x() < 0.3 || -x.x() > 0.8) continue;
    std::vector<double>& both = told[vertex];
    std::ranges::sort(both);
    ASSERT_EQ(both.size(), 2U) << x.transpose();
    EXPECT_NEAR(both[0], std::min(first, second), 0.02 * radius);
    EXPECT_NEAR(both[1], std::max(first, second), 0.02 * radius);
    ++checked;
  }
  EXPECT_GT(checked, 500U);
}

// An arc of half the radius: no corner, but too sharp for the stroke's outside.
TEST(LongBends, SmoothBoundsTheGradientOfT) {
  Scene scene;
  const double bend = radius / 2;
  std::vector<Vec3d> samples;
  for (int i = 0; i < 60; ++i) samples.emplace_back(-0.9 + 0.9 * i / 60., 0, 0);
  for (int i = 0; i <= 30; ++i) {
    const double angle = std::numbers::pi / 2 * i / 30;
    samples.emplace_back(bend * std::sin(angle), bend - bend * std::cos(angle), 0);
  }
  for (int i = 1; i <= 60; ++i) samples.emplace_back(bend, bend + 0.8 * i / 60., 0);
  const SurfaceCurve curve = scene.traced(samples);
  const Chart plain = scene.builder.chart(curve, {.radius = radius});
  const Chart smooth = scene.builder.chart(curve, {.radius = radius, .join = Join::smooth});
  const auto least = [&](const Chart& chart) {
    double gradient = 10;
    for (const ChartTriangle& triangle : triangles_of(scene.surface, chart)) {
      const Vec2d from_centre = triangle.middle - Vec2d(0, bend);
      const bool outside = from_centre.x() > 0 && from_centre.y() < 0 && from_centre.norm() > bend;
      if (outside) gradient = std::min(gradient, triangle.grad_t.norm());
    }
    return gradient;
  };
  EXPECT_LT(least(plain), 0.4);  // 1 / (1 + r / bend)
  for (const ChartTriangle& triangle : triangles_of(scene.surface, smooth)) {
    const Vec2d from_centre = triangle.middle - Vec2d(0, bend);
    const bool wedge = (from_centre.dot(Vec2d(-1, 1)) > -2 * edge && triangle.middle.norm() < 3 * radius) ||
                       from_centre.norm() < 5 * edge;  // the arc is focused there
    if (wedge || triangle.middle.norm() > 0.7) continue;
    expect_sound(triangle);
  }
}

// Figure 14: a stroke wider than its turning radius, to and fro, and turns of 180 degrees.
TEST(HardBends, StayFiniteAndWithinTheStroke) {
  Scene scene;
  for (const double waves : {3., 6., 12.}) {
    std::vector<Vec3d> samples;
    for (int i = 0; i <= 300; ++i) {
      const double s = i / 300.;
      samples.emplace_back(-0.7 + 1.4 * s, 0.25 * std::sin(2 * std::numbers::pi * waves * s), 0);
    }
    const SurfaceCurve curve = scene.traced(samples);
    for (const Join join : {Join::round, Join::smooth, Join::miter, Join::overlap}) {
      const Chart chart = scene.builder.chart(curve, {.radius = radius, .join = join});
      EXPECT_GT(chart.size(), 5000U);
      for (std::size_t i = 0; i < chart.size(); ++i) {
        ASSERT_TRUE(std::isfinite(chart.t[i]) && chart.e1[i].allFinite() && std::isfinite(chart.stretch[i]));
        ASSERT_LE(std::abs(chart.d[i]), radius * 1.000001);
        ASSERT_TRUE(chart.t[i] > -3 * radius && chart.t[i] < curve.length() + 3 * radius);
        if (i > 0 && chart.vertex[i] == chart.vertex[i - 1]) {
          ASSERT_EQ(chart.sheet[i], chart.sheet[i - 1] + 1);
        }
      }
    }
  }
}

// Straight runs with corners as tight as a pen makes them.
TEST(HardBends, LeaveHardlyAHole) {
  Scene scene;
  std::size_t within = 0, missing = 0;
  for (const double height : {0.8, 1.2, 2.}) {
    std::vector<Vec3d> samples;
    for (int i = 0; i <= 120; ++i) {
      const double run = i / 30., share = run - std::floor(run), sign = i / 30 % 2 == 0 ? 1 : -1;
      samples.emplace_back(radius * (-3 + 6 * i / 120.), radius * sign * height * (2 * share - 1), 0);
    }
    const SurfaceCurve curve = scene.traced(samples);
    const Chart chart = scene.builder.chart(curve, {.radius = radius});
    std::vector<bool> held(scene.surface.vertex_count(), false);
    for (const Index vertex : chart.vertex) held[vertex] = true;
    for (Index v = 0; v < scene.surface.vertex_count(); ++v) {
      const Vec3f& x = scene.surface.positions[v];
      if (x.cwiseAbs().maxCoeff() > 0.95F) continue;
      const bool near = std::ranges::any_of(curve.points, [&](const CurvePoint& point) {
        return (point.at.position - x).norm() < 0.97F * static_cast<float>(radius);
      });
      within += near;
      missing += near && !held[v];
    }
  }
  EXPECT_GT(within, 20000U);
  EXPECT_LE(missing, within / 200);
}

INSTANTIATE_TEST_SUITE_P(Turns, Joins, testing::Values(45., 90., -90.), [](const auto& turn) {
  return (turn.param < 0 ? "Right" : "Left") + std::to_string(std::abs(static_cast<int>(turn.param)));
});

}  // namespace
}  // namespace burin
