#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/feature/snap.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "feature/known_lines.h"
#include "sanitizers/processor_seconds.h"
#include "sanitizers/sanitized.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Samples of a pen along a line that swings to both sides of a parallel of it; distances in object units.
std::vector<Vec3d> pen_beside(const KnownLine& known, double mean, double swing, double waves) {
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) {
    const double s = i / 60.;
    pen.push_back(known.beside(s, mean + swing * std::sin(turn * waves * s + 0.3)));
  }
  return pen;
}

/// Errors of a snapped stroke, and what part of it was snapped.
struct Errors {
  double median, p95, share;
};

Errors errors_of(const SnapResult& result, const std::function<double(const Vec3d&)>& distance) {
  const std::vector<double> all = distances(result, distance);
  return {quantile(all, 0.5), quantile(all, 0.95), result.snapped_share};
}

void expect_within(const Errors& errors, double median, double p95, const std::string& what) {
  std::cout << what << ": median " << errors.median << ", p95 " << errors.p95 << " edges\n";
  EXPECT_LE(errors.median, median) << what;
  EXPECT_LE(errors.p95, p95) << what;
  EXPECT_GE(errors.share, 0.95) << what;
}

using MakeRidge = KnownLine (*)(double w, double h, double reach, double length, std::uint32_t seed);

const std::pair<const char*, MakeRidge> ridges[] = {
    {"arc in a plane", [](double w, double h, double reach, double length,
                          std::uint32_t seed) { return ridge_in_plane(w, h, 150, reach, length, seed); }},
    {"circle of latitude",
     [](double w, double h, double reach, double length, std::uint32_t seed) {
       return ridge_on_sphere(w, h, 150, 0.9, reach, length, seed);
     }},
    {"line on a saddle", [](double w, double h, double reach, double length, std::uint32_t seed) {
       return ridge_on_saddle(w, h, 150, reach, length, seed);
     }}};

/// Snaps to ridges of several widths with a scale of half the width; `height` in widths, `noise` in edges.
void expect_ridges_within(FeatureKind kind, double height, double noise, double median, double p95) {
  for (const double w : {3., 8., 20.}) {
    for (const auto& [name, make] : ridges) {
      const double r = std::max(12., 2.5 * w);
      KnownLine known = make(w, height * w, r, 4 * r, 3);
      if (noise > 0) add_noise(known.mesh, noise, 8);
      SnapScene scene(known.mesh);
      const SnapResult result =
          scene.snap(pen_beside(known, 0.3 * r, 0.15 * r, 2), {kind}, {.radius = r, .scale = w / 2});
      expect_within(errors_of(result, known.distance), median, p95,
                    std::string(name) + ", width " + std::to_string(w));
    }
  }
}

TEST(Snap, FindsRidgesToATenthOfAnEdge) { expect_ridges_within(FeatureKind::ridge, 0.5, 0, 0.1, 0.5); }

TEST(Snap, FindsRidgesInNoiseOfATwentiethOfAnEdge) {
  expect_ridges_within(FeatureKind::ridge, 0.5, 0.05, 0.25, 1);
}

TEST(Snap, FindsValleysToATenthOfAnEdge) {
  const KnownLine known = ridge_on_sphere(5, -2.5, 150, 0.9, 15, 60, 3);
  SnapScene scene(known.mesh);
  const SnapResult result =
      scene.snap(pen_beside(known, -4, 2, 2), {FeatureKind::valley}, {.radius = 15, .scale = 2.5});
  expect_within(errors_of(result, known.distance), 0.1, 0.5, "valley");
}

TEST(Snap, FindsSharpEdgesToATenthOfAnEdge) {
  // Slopes on both sides of an arc of radius 60, which is an edge of 2 arctan(slope).
  constexpr double bend = 60;
  for (const double slope : {0.2, 1., 2.}) {
    const auto at = [&](double u, double v) {
      const double angle = u / bend;
      return Vec3d((bend - v) * std::sin(angle), bend - (bend - v) * std::cos(angle), -slope * std::abs(v));
    };
    SnapScene scene(shuffled(patch({-40, 40, -20, 20, 80, 40, false, 0.3, 0, 3}, at), 4));
    std::vector<Vec3d> pen;
    for (int i = 0; i <= 60; ++i) pen.push_back(at(i - 30, 3 + std::sin(i / 6.)));
    const SnapResult result = scene.snap(pen, {FeatureKind::ridge}, {.radius = 10});
    const auto distance = [&](const Vec3d& x) {
      return std::abs(bend - std::hypot(x.x(), x.y() - bend)) * std::sqrt(1 + slope * slope);
    };
    expect_within(errors_of(result, distance), 0.1, 0.5, "slope " + std::to_string(slope));
  }
}

/// The ellipsoid (x / a)^2 + (y / b)^2 + (z / c)^2 = 1.
struct Ellipsoid {
  Vec3d axes{1, 0.7, 0.5};
  TriangleMesh mesh = scaled(sphere(6, 0.25, 3), axes);
  double edge = 0.0144;  ///< mean

  static TriangleMesh scaled(TriangleMesh mesh, const Vec3d& by) {
    for (Vec3f& position : mesh.positions) position = position.cwiseProduct(by.cast<float>());
    return shuffled(mesh, 4);
  }
  /// The point in this direction from the centre of the sphere that the ellipsoid is stretched from.
  Vec3d at(const Vec3d& direction) const { return direction.normalized().cwiseProduct(axes); }
};

TEST(Snap, FindsThePrincipalRidgeOfAnEllipsoid) {
  const Ellipsoid ellipsoid;
  SnapScene scene(ellipsoid.mesh);
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) {
    const double s = 4.5 * i / 60;
    pen.push_back(ellipsoid.at({std::cos(s), std::sin(s), 0.1 + 0.05 * std::sin(4 * s)}));
  }
  const SnapResult result = scene.snap(pen, {FeatureKind::ridge}, {.radius = 0.25});
  expect_within(errors_of(result, [&](const Vec3d& x) { return std::abs(x.z()) / ellipsoid.edge; }), 0.1, 0.5,
                "z = 0");
}

/// The distance of a point from a curve, searched near a parameter.
double distance_from(const Vec3d& x, const std::function<Vec3d(double)>& curve, double near) {
  double least = 1e9;
  for (int i = -500; i <= 500; ++i) least = std::min(least, (curve(near + i * 2e-4) - x).norm());
  return least;
}

TEST(Snap, FindsTheSilhouetteOfAnEllipsoid) {
  const Ellipsoid ellipsoid;
  SnapScene scene(ellipsoid.mesh);
  const Vec3d view = Vec3d(0.3, -0.4, -1).normalized();
  // The silhouette is the image of a great circle.
  const Vec3d pole = view.cwiseQuotient(ellipsoid.axes).normalized(), a = pole.unitOrthogonal(),
              b = pole.cross(a);
  const auto at = [&](double s, double off) {
    return ellipsoid.at(std::cos(s) * a + std::sin(s) * b + off * pole);
  };
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) pen.push_back(at(4.5 * i / 60, 0.15 + 0.08 * std::sin(4 * 4.5 * i / 60)));
  const SnapResult result = scene.snap(pen, {FeatureKind::silhouette, {false, view}}, {.radius = 0.2});
  const auto distance = [&](const Vec3d& x) {
    const Vec3d on_sphere = x.cwiseQuotient(ellipsoid.axes);
    return distance_from(
               x, [&](double s) { return at(s, 0); }, std::atan2(on_sphere.dot(b), on_sphere.dot(a))) /
           ellipsoid.edge;
  };
  expect_within(errors_of(result, distance), 0.05, 0.3, "ellipsoid");
}

TEST(Snap, FindsTheSilhouetteOfASphereFromNearby) {
  SnapScene scene(shuffled(sphere(6, 0.25, 3), 4));
  const Vec3d eye(0.5, 0.7, 3), axis = eye.normalized(), a = axis.unitOrthogonal(), b = axis.cross(a);
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 40; ++i) {
    const double s = 2.5 * i / 40;
    pen.push_back((std::cos(s) * a + std::sin(s) * b + (0.15 + 0.08 * std::sin(4 * s)) * axis).normalized());
  }
  const SnapResult result = scene.snap(pen, {FeatureKind::silhouette, {true, eye}}, {.radius = 0.4});
  constexpr double edge = 0.0192;
  const auto distance = [&](const Vec3d& x) {
    return std::abs(std::acos(x.normalized().dot(axis)) - std::acos(1 / eye.norm())) / edge;
  };
  expect_within(errors_of(result, distance), 0.05, 0.3, "sphere");
}

TEST(Snap, FindsBothSheetsOfTheSilhouetteOfATorus) {
  constexpr double large = 1, small = 0.4, edge = 0.0489;
  const auto at = [&](double u, double v) {
    const double from_axis = large + small * std::cos(v);
    return Vec3d(from_axis * std::cos(u), from_axis * std::sin(u), small * std::sin(v));
  };
  SnapScene scene(shuffled(patch({0, turn, -turn / 2, turn / 2, 150, 60, true, 0.3, 0.3, 3}, at), 5));
  const Vec3d view = Vec3d(0.3, 0.5, -1).normalized();
  for (const double sheet : {0., std::numbers::pi}) {
    // n . view = 0 with n = (cos v cos u, cos v sin u, sin v).
    const auto line = [&](double u) {
      return std::atan2(-(std::cos(u) * view.x() + std::sin(u) * view.y()), view.z()) + sheet;
    };
    std::vector<Vec3d> pen;
    for (int i = 0; i <= 40; ++i) {
      const double u = 0.3 + 2.5 * i / 40;
      pen.push_back(at(u, line(u) + 0.25 + 0.15 * std::sin(4 * u)));
    }
    const SnapResult result = scene.snap(pen, {FeatureKind::silhouette, {false, view}}, {.radius = 0.25});
    const auto distance = [&](const Vec3d& x) {
      return distance_from(
                 x, [&](double u) { return at(u, line(u)); }, std::atan2(x.y(), x.x())) /
             edge;
    };
    expect_within(errors_of(result, distance), 0.05, 0.3, sheet == 0 ? "outer sheet" : "inner sheet");
  }
}

TEST(Snap, FollowsTheBorderExactly) {
  const double half = 30;
  SnapScene scene(shuffled(plane(half, 1, 5), 6));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 30; ++i) pen.emplace_back(-20 + 40 * i / 30., half - 4 + 2 * std::sin(i / 4.), 0);
  const SnapResult result = scene.snap(pen, {FeatureKind::border}, {.radius = 10});
  expect_within(errors_of(result, [&](const Vec3d& x) { return std::abs(x.y() - half); }), 1e-5, 1e-5,
                "border");
}

TEST(Snap, FindsTheCrestOfAValueOfTheVertices) {
  TriangleMesh mesh = shuffled(plane(40, 1, 5), 6);
  SnapScene scene(mesh);
  // A dark line along an arc, rounded to bytes as colours are.
  const auto off = [](const Vec3d& x) { return std::hypot(x.x(), x.y() + 100) - 100; };
  std::vector<float> values;
  for (const Vec3f& position : scene.surface.positions) {
    const double d = off(position.cast<double>());
    values.push_back(static_cast<float>(std::round(200 - 150 * std::exp(-d * d / 18))));
  }
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 30; ++i) pen.emplace_back(-25 + 50 * i / 30., 3 + 2 * std::sin(i / 3.), 0);
  const SnapResult result = scene.snap(pen, {FeatureKind::low, {}, values}, {.radius = 15});
  expect_within(errors_of(result, [&](const Vec3d& x) { return std::abs(off(x)); }), 0.1, 0.5, "dark line");
  EXPECT_TRUE(scene.snap(pen, {FeatureKind::high, {}, std::vector<float>(values.size(), 7)}, {.radius = 15})
                  .ranges.empty())
      << "where a value is the same everywhere nothing stands out";
}

/// A uniform random number in [0, 1).
double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.; }

TEST(Snap, CapturesStrokesThatStartHalfARadiusAwayOrWeave) {
  constexpr std::uint32_t seed = 7;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  int captured = 0, all = 0, weaving = 0;
  for (const auto& [name, make] : ridges) {
    const double w = 5, r = 18;
    const KnownLine known = make(w, w / 2, r, 6 * r, 3);
    SnapScene scene(known.mesh);
    for (int i = 0; i < 12; ++i) {
      const bool weaves = i % 2 == 0;
      const double mean = weaves ? 0.2 * (2 * uniform(random) - 1) : i % 4 == 1 ? 0.5 : -0.5;
      const double swing = weaves ? 0.3 + 0.15 * uniform(random) : 0, waves = 1 + 1.2 * uniform(random);
      const SnapResult result =
          scene.snap(pen_beside(known, mean * r, swing * r, waves), {FeatureKind::ridge}, {.radius = r});
      const Errors errors = errors_of(result, known.distance);
      captured += errors.share > 0.9 && errors.p95 < 1;
      weaving += weaves;
      ++all;
    }
  }
  EXPECT_EQ(weaving, all / 2);
  EXPECT_GE(captured, 0.95 * all) << "of " << all;
}

TEST(Snap, LeavesStrokesAloneWhereThereIsNothing) {
  constexpr std::uint32_t seed = 9;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const std::pair<const char*, TriangleMesh> surfaces[] = {
      {"plane", shuffled(plane(60, 1, 3), 4)},
      {"cylinder", shuffled(cylinder(40, 60, 1, 0.3, 3), 4)},
      {"sphere", Ellipsoid::scaled(sphere(6, 0.25, 3), Vec3d::Constant(60))}};
  for (const auto& [name, mesh] : surfaces) {
    for (const double noise : {0., 0.05}) {
      TriangleMesh noisy = mesh;
      if (noise > 0) add_noise(noisy, noise, 5);
      SnapScene scene(noisy);
      for (int i = 0; i < 10; ++i) {
        const Vec3d from = scene.surface.positions[scene.surface.vertex_count() / 2].cast<double>();
        const Vec3d normal = from.normalized(), a = normal.unitOrthogonal(), b = normal.cross(a);
        const double angle = turn * uniform(random), swing = 5 * uniform(random);
        const Vec3d along = std::cos(angle) * a + std::sin(angle) * b, side = normal.cross(along);
        std::vector<Vec3d> pen;
        for (int k = -30; k <= 30; ++k) pen.push_back(from + along * k + side * swing * std::sin(k / 7.));
        for (Vec3d& place : pen)
          if (const auto at = scene.picker.closest(place.cast<float>(), 100))
            place = at->position.cast<double>();
        const SnapResult result =
            scene.snap(pen, {i % 2 ? FeatureKind::ridge : FeatureKind::valley}, {.radius = 16});
        EXPECT_TRUE(result.ranges.empty()) << name << ", noise " << noise << ", " << result.significance;
        ASSERT_EQ(result.curve.points.size(), scene.stroke.points.size());
        for (std::size_t k = 0; k < result.curve.points.size(); ++k)
          EXPECT_EQ(result.curve.points[k].at.position, scene.stroke.points[k].at.position);
      }
    }
  }
}

/// A plane with a ridge along y = 0 that ends at x = 0.
KnownLine half_ridge() {
  const auto height = [](double x, double y) {
    return 2.5 * std::exp(-y * y / 50) * (x < 0 ? 1 : std::exp(-x * x / 50));
  };
  return {shuffled(patch({-70, 70, -30, 30, 160, 69, false, 0.3, 0.3, 3},
                         [&](double x, double y) { return Vec3d(x, y, height(x, y)); }),
                   4),
          {},
          {},
          [](const Vec3d& x) { return std::abs(x.y()); }};
}

TEST(Snap, StaysOnTheStrokeBeyondTheEndOfAFeature) {
  const KnownLine known = half_ridge();
  SnapScene scene(known.mesh);
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) pen.emplace_back(-60 + 2 * i, 5, 0);
  const SnapResult result = scene.snap(pen, {FeatureKind::ridge}, {.radius = 15});
  ASSERT_EQ(result.ranges.size(), 1u);
  EXPECT_NEAR(result.ranges[0].from, 0, 1);
  EXPECT_NEAR(result.ranges[0].to, 75, 8) << "where the ridge has fallen to a hundredth";
  EXPECT_NEAR(result.mean_move, 5, 0.5);
  std::size_t own = 0;
  for (std::size_t i = 0; i < result.curve.points.size(); ++i) {
    if (result.stroke_t[i] < result.ranges[0].to + 12) continue;
    ++own;
    EXPECT_TRUE(std::ranges::any_of(scene.stroke.points, [&](const CurvePoint& point) {
      return point.at.position == result.curve.points[i].at.position;
    }));
  }
  EXPECT_GT(own, 40u);
  for (std::size_t i = 1; i < result.curve.points.size(); ++i)
    EXPECT_LT((result.curve.points[i].at.position - result.curve.points[i - 1].at.position).norm(), 1.5)
        << "the transition has no gap";
}

TEST(Snap, HoldsFixedEnds) {
  const KnownLine known = ridge_in_plane(5, 2.5, 150, 15, 100, 3);
  SnapScene scene(known.mesh);
  const auto pen = pen_beside(known, 5, 0, 1);
  const SnapResult held = scene.snap(pen, {FeatureKind::ridge}, {.radius = 15, .fixed_ends = true});
  EXPECT_EQ(held.curve.points.front().at.position, scene.stroke.points.front().at.position);
  EXPECT_EQ(held.curve.points.back().at.position, scene.stroke.points.back().at.position);
  expect_within({errors_of(held, known.distance).median, errors_of(held, known.distance).p95, 1}, 0.1, 0.5,
                "between");
  const SnapResult free = scene.snap(pen, {FeatureKind::ridge}, {.radius = 15});
  EXPECT_LT(known.distance(free.curve.points.front().at.position.cast<double>()), 1);
}

TEST(Snap, KeepsClosedStrokesClosed) {
  // A ring-shaped ridge around the z axis.
  const auto height = [](double x, double y) {
    const double d = std::hypot(x, y) - 40;
    return 2.5 * std::exp(-d * d / 50);
  };
  SnapScene scene(shuffled(patch({-65, 65, -65, 65, 150, 150, false, 0.3, 0.3, 3},
                                 [&](double x, double y) { return Vec3d(x, y, height(x, y)); }),
                           4));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 90; ++i) {
    const double s = turn * i / 90, r = 44 + 2 * std::sin(5 * s);
    pen.emplace_back(r * std::cos(s), r * std::sin(s), height(r * std::cos(s), r * std::sin(s)));
  }
  const SnapResult result = scene.snap_closed(pen, {FeatureKind::ridge}, {.radius = 15});
  EXPECT_TRUE(result.curve.closed);
  EXPECT_NEAR(result.curve.length(), turn * 40, 0.5);
  expect_within(errors_of(result, [](const Vec3d& x) { return std::abs(std::hypot(x.x(), x.y()) - 40); }),
                0.1, 0.5, "ring");
}

TEST(Snap, MayBeCalledWhileThePenDraws) {
  const KnownLine known = ridge_in_plane(5, 2.5, 150, 15, 100, 3);
  SnapScene scene(known.mesh);
  const auto pen = pen_beside(known, 4, 2, 2);
  for (std::size_t samples = 1; samples <= pen.size(); samples += 12) {
    const std::vector<Vec3d> so_far(pen.begin(), pen.begin() + static_cast<std::ptrdiff_t>(samples));
    const SnapResult live = scene.snap(so_far, {FeatureKind::ridge}, {.radius = 15});
    StrokeSnapper fresh(scene.surface, scene.picker);
    const SnapResult alone = fresh.snap(scene.stroke, {FeatureKind::ridge}, {.radius = 15});
    ASSERT_EQ(live.curve.points.size(), alone.curve.points.size());
    for (std::size_t i = 0; i < live.curve.points.size(); ++i)
      ASSERT_EQ(live.curve.points[i].at.position, alone.curve.points[i].at.position);
    if (samples < 20) continue;
    EXPECT_GT(live.snapped_share, 0.9) << samples << " samples";
    EXPECT_LT(errors_of(live, known.distance).p95, 0.5);
  }
}

TEST(Snap, TakesAboutTwiceTheTimeOfOneChart) {
  if (test::sanitized) GTEST_SKIP() << "sanitizers slow different work down differently";
  const double r = 18;
  const KnownLine known = ridge_on_sphere(5, 2.5, 150, 0.9, r, 195, 3);
  SnapScene scene(known.mesh);
  const auto pen = pen_beside(known, 0.3 * r, 0.15 * r, 2);
  ASSERT_GT(scene.snap(pen, {FeatureKind::ridge}, {.radius = r}).snapped_share, 0.95);
  StrokeChartBuilder builder(scene.surface);
  const ThreadLimit one_thread(1);
  // In turn, so that whatever slows the machine down slows both.
  double snap = 1e9, chart = 1e9;
  std::size_t nodes = 0;
  for (int i = 0; i < 9; ++i) {
    snap = std::min(snap, processor_seconds([&] {
                      scene.snapper.snap(scene.stroke, {FeatureKind::ridge}, {.radius = r});
                    }));
    chart = std::min(chart,
                     processor_seconds([&] { nodes = builder.chart(scene.stroke, {.radius = r}).size(); }));
  }
  std::cout << nodes << " vertices in reach: " << 1e3 * snap << " ms, its chart " << 1e3 * chart << " ms\n";
  EXPECT_NEAR(static_cast<double>(nodes), 10'000, 500);
  EXPECT_LT(snap, 2.2 * chart);
}

TEST(Snap, RefusesWhatItCannotDo) {
  SnapScene scene(plane(5, 1, 3));
  const std::vector<Vec3d> pen = {{-2, 0, 0}, {2, 0, 0}};
  EXPECT_THROW(scene.snap(pen, {FeatureKind::high}, {.radius = 2}), ContractError) << "without values";
  EXPECT_THROW(scene.snapper.snap({}, {}, {.radius = 2}), ContractError);
  EXPECT_THROW(scene.snapper.snap(scene.stroke, {}, {.radius = 0}), ContractError);
  EXPECT_THROW(scene.snapper.snap(scene.stroke, {}, {.radius = 1, .iterations = 0}), ContractError);
  EXPECT_TRUE(scene.snap({{0, 0, 0}}, {FeatureKind::ridge}, {.radius = 2}).ranges.empty())
      << "a single point";
}

}  // namespace
}  // namespace burin::test
