#include <burin/stroke/curve/end_distances.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace burin {
namespace {

using std::numbers::pi;
constexpr double brush_radius = 1, most = 2;

using Way = std::function<Vec2d(double)>;

Vec3f in_plane(const Vec2d& at) { return {static_cast<float>(at.x()), static_cast<float>(at.y()), 0}; }

/// A curve in the plane of this length; `way` tells its point at an arc length.
SurfaceCurve curve_of(double length, const Way& way, int segments = 400) {
  SurfaceCurve curve;
  for (int i = 0; i <= segments; ++i) {
    CurvePoint point{};
    point.normal = Vec3f::UnitZ();
    point.tangent = Vec3f::UnitX();
    point.t = length * i / segments;
    point.at.position = in_plane(way(point.t));
    curve.points.push_back(point);
  }
  return curve;
}

Vec2d along_x(double t) { return {t, 0}; }

/// Along x up to t = 4.5, and from there along y: no part of it is nearer to what lies at t < 2.
Vec2d corner_far_off(double t) { return t < 4.5 ? Vec2d(t, 0) : Vec2d(4.5, t - 4.5); }

/// The distance where the stroke, or what is behind it, runs along `direction`; left of it d is positive.
float at(const EndDistances& ends, double t, double d, const Vec2d& direction = {1, 0}) {
  return ends.at(t, d, in_plane(direction), Vec3f::UnitZ());
}

TEST(EndDistances, BesideALineAreThoseOfT) {
  const double length = 20;
  const EndDistances ends(curve_of(length, along_x), brush_radius, most);
  for (const double d : {-1., -0.3, 0., 0.7})
    for (const double t : {0., 0.03, 0.4, 1.9, 2.5, 10.}) {
      EXPECT_FLOAT_EQ(at(ends, t, d), static_cast<float>(std::min(t, most)));
      EXPECT_NEAR(at(ends, length - t, d), std::min(t, most), 1e-6) << t << ' ' << d << " from the end";
    }
}

TEST(EndDistances, AreTheSameWhereTheStrokeBendsFartherOff) {
  const EndDistances ends(curve_of(20, corner_far_off, 2000), brush_radius, most);
  ASSERT_TRUE(ends.begin_bends());
  for (const double d : {-1., -0.3, -0.01, 0., 0.1, 0.7, 1.})
    for (const double t : {0., 0.03, 0.4, 1., 1.2, 1.9})
      EXPECT_NEAR(at(ends, t, d), t, 1e-5) << t << ' ' << d;
}

TEST(EndDistances, AreZeroBehindTheEnds) {
  for (const Way& way : {Way(along_x), Way(corner_far_off)}) {
    const EndDistances ends(curve_of(20, way, 2000), brush_radius, most);
    for (const double d : {-0.6, 0., 0.3})
      for (const double t : {-0.01, -0.3, -0.7}) EXPECT_NEAR(at(ends, t, d), 0, 1e-5) << t << ' ' << d;
  }
}

// The minimum of t and 1 - t, less (1/2 - |2 t - 1|)^2 / 2 where these differ by less than 1/2.
TEST(EndDistances, AreRoundedInTheMiddleOfShortStrokes) {
  const EndDistances ends(curve_of(1, along_x), brush_radius, most);
  EXPECT_FLOAT_EQ(at(ends, 0, 0.3), 0);
  EXPECT_FLOAT_EQ(at(ends, 0.25, 0.3), 0.25f);
  EXPECT_FLOAT_EQ(at(ends, 0.375, 0.3), 0.34375f);
  EXPECT_FLOAT_EQ(at(ends, 0.5, 0), 0.375f);
  EXPECT_FLOAT_EQ(at(ends, 0.75, 0.3), 0.25f);
  const EndDistances longer(curve_of(4, along_x), brush_radius, most);
  EXPECT_FLOAT_EQ(at(longer, 1.9, 0.3), 1.9f) << "nothing depends on the length farther back than `most`";
}

TEST(EndDistances, OfATapAreZero) {
  const EndDistances tap(curve_of(0, along_x), brush_radius, most);
  EXPECT_EQ(at(tap, 0, 0), 0);
}

TEST(EndDistances, AreTheGreatestWithoutEnds) {
  SurfaceCurve circle = curve_of(2 * pi, [](double t) { return Vec2d(std::cos(t), std::sin(t)); });
  circle.points.pop_back();
  circle.closed = true;
  circle.closing_length = 2 * pi / 400;
  EXPECT_EQ(at(EndDistances(circle, brush_radius, most), 0.1, 0), 2);
  EXPECT_EQ(at(EndDistances(2), 0, 0.3), 2);
  EXPECT_TRUE(std::isfinite(at(EndDistances(std::numeric_limits<double>::infinity()), 0, 0.3)));
}

/// The greatest steps of the distances and of t between points of a grid, whose nearest points are exact.
struct Steps {
  double distance = 0, t = 0;
};
Steps greatest(const SurfaceCurve& curve) {
  const EndDistances ends(curve, brush_radius, most);
  EXPECT_TRUE(ends.begin_bends());
  constexpr double step = 0.01;
  const auto told = [&](const Vec2d& position) {
    double nearest = 1e9, t = 0;
    Vec2d ray;
    for (const CurvePoint& point : curve.points) {
      const Vec2d from(position - point.at.position.head<2>().cast<double>());
      if (from.norm() < nearest) nearest = from.norm(), t = point.t, ray = from;
    }
    return Vec2d(at(ends, t, nearest, Vec2d(ray.y(), -ray.x()).normalized()), t);
  };
  Steps steps;
  for (double x = -0.9; x < 0.9; x += step)
    for (double y = -0.9; y < 0.9; y += step) {
      const Vec2d change = told({x + step, y}) - told({x, y});
      steps.distance = std::max(steps.distance, std::abs(change.x()));
      steps.t = std::max(steps.t, std::abs(change.y()));
    }
  return steps;
}

// The nearest point changes by up to half a turn across the centre of a circle, and from leg to leg between
// those of a corner.
TEST(EndDistances, HaveSmallStepsInsideOfBends) {
  constexpr double of_slopes = 0.04;
  for (const double bend : {0.15, 0.3, 0.5, 0.8}) {
    const Steps steps = greatest(curve_of(1.6 * pi * bend, [&](double t) {
      return Vec2d(bend * std::cos(t / bend), bend * std::sin(t / bend));
    }));
    EXPECT_LE(steps.distance, 0.36 * bend + of_slopes) << "a circle of " << bend;
    EXPECT_GE(steps.t, 1.5 * bend) << "a circle of " << bend;
  }
  for (const double angle : {0.3, 0.8, 1.5}) {
    // Its legs come back by less than what makes another visit.
    const double leg = 0.3;
    const Steps steps = greatest(curve_of(2 * leg, [&](double t) {
      const double s = t - leg;
      return s < 0 ? Vec2d(-s, 0) : Vec2d(s * std::cos(angle), s * std::sin(angle));
    }));
    EXPECT_LE(steps.distance, 0.36 * leg * std::tan(angle / 2) + of_slopes) << "a corner of " << angle;
    EXPECT_GE(steps.t, leg) << "a corner of " << angle;
  }
}

TEST(EndDistances, OfOtherVisitsDoNotCount) {
  // A hairpin: the second leg passes the begin at a distance of 0.6, after it went away by 2.
  const EndDistances ends(curve_of(4 + 0.3 * pi,
                                   [](double t) {
                                     if (t < 2) return Vec2d(t, 0);
                                     const double turn = (t - 2) / 0.3;
                                     if (turn < pi)
                                       return Vec2d(2 + 0.3 * std::sin(turn), 0.3 - 0.3 * std::cos(turn));
                                     return Vec2d(2 - (t - 2 - 0.3 * pi), 0.6);
                                   }),
                          brush_radius, most);
  EXPECT_TRUE(ends.begin_bends());
  EXPECT_LT(at(ends, 0, 0), 0.01f);
}

TEST(EndDistances, DoNotDependOnWhatLiesFartherThanTheirReach) {
  const std::uint32_t seed = 5;
  std::mt19937 random(seed);
  const double seen = most + EndDistances::reach(brush_radius, most);
  const auto wave = [](double t) { return Vec2d(0.8 * t, 0.6 * std::sin(3 * t)); };
  const EndDistances shorter(curve_of(seen + 2.5, wave, 4250), brush_radius, most),
      longer(curve_of(2 * (seen + 2.5), wave, 8500), brush_radius, most);
  ASSERT_TRUE(shorter.begin_bends());
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const double t = most * static_cast<double>(random()) / 4294967296.,
                 d = static_cast<double>(random()) / 4294967296.;
    const float distance = at(shorter, t, d);
    ASSERT_EQ(distance, at(longer, t, d)) << t << ' ' << d << ", seed " << seed;
    inside += distance < most;
  }
  EXPECT_GT(inside, 500);
}

}  // namespace
}  // namespace burin
