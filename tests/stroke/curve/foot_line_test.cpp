#include <burin/stroke/curve/foot_line.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

CurvePoint point_at(const Vec3d& place, double t, const Vec3f& normal = Vec3f::UnitZ()) {
  CurvePoint point{};
  point.at.position = place.cast<float>();
  point.normal = normal;
  point.t = t;
  return point;
}

/// Along x from 0 to 4, on a bump z = x in the middle part 1 <= x <= 3 only: z is 0, x - 1, 2.
SurfaceCurve ramp() {
  SurfaceCurve curve;
  curve.points = {point_at({0, 0, 0}, 0), point_at({1, 0, 0}, 1), point_at({3, 0, 2}, 3),
                  point_at({4, 0, 2}, 4)};
  return curve;
}

TEST(FootLine, IsTheMeanOverTheReach) {
  const FootLine line(ramp(), 0.5);
  EXPECT_NEAR((line.at(2).position - Vec3f(2, 0, 1)).norm(), 0, 1e-6);
  // The height z over [0.5, 1.5] is 0 in the first half and rises to 0.5 in the second.
  EXPECT_NEAR((line.at(1).position - Vec3f(1, 0, 0.125f)).norm(), 0, 1e-6);
}

TEST(FootLine, EndsWithTheCurve) {
  const FootLine line(ramp(), 0.5);
  EXPECT_NEAR((line.at(0).position - Vec3f(0.25f, 0, 0)).norm(), 0, 1e-6);
  EXPECT_EQ(line.at(-3).position, line.at(0).position);
  EXPECT_EQ(line.at(9).position, line.at(4).position);
  EXPECT_NEAR((FootLine(ramp(), 100).at(2).position - Vec3f(2, 0, 1)).norm(), 0, 1e-6) << "of all of it";
}

TEST(FootLine, GoesRoundAClosedCurve) {
  constexpr int count = 400;
  SurfaceCurve circle;
  circle.closed = true;
  const double step = 2 * std::acos(-1) / count;
  for (int i = 0; i < count; ++i)
    circle.points.push_back(
        point_at({std::cos(i * step), std::sin(i * step), 0}, i * step,
                 Vec3f(static_cast<float>(std::cos(i * step)), static_cast<float>(std::sin(i * step)), 0)));
  circle.closing_length = step;
  const FootLine line(circle, 0.3);
  // The mean of a circle over an arc of 0.6 lies at sin(0.3) / 0.3 of the radius.
  for (const double t : {0.0, 0.1, 2.0, 6.2, -0.1}) {
    const Vec3f out(static_cast<float>(std::cos(t)), static_cast<float>(std::sin(t)), 0);
    EXPECT_NEAR((line.at(t).position - static_cast<float>(std::sin(0.3) / 0.3) * out).norm(), 0, 1e-4) << t;
    EXPECT_NEAR((line.at(t).normal - out).norm(), 0, 1e-4) << t;
  }
}

TEST(FootLine, OfOnePointIsThatPoint) {
  SurfaceCurve dot;
  dot.points = {point_at({1, 2, 3}, 0, Vec3f::UnitY())};
  EXPECT_EQ(FootLine(dot, 1).at(0.4).position, Vec3f(1, 2, 3));
  EXPECT_EQ(FootLine(dot, 1).at(0.4).normal, Vec3f::UnitY());
}

TEST(FootLine, TakesThePointsOwnNormalWhereNormalsCancelOut) {
  SurfaceCurve fold;
  fold.points = {point_at({0, 0, 0}, 0), point_at({1, 0, 0}, 1), point_at({1, 0, 0}, 1, -Vec3f::UnitZ()),
                 point_at({0, 0, 0}, 2, -Vec3f::UnitZ())};
  const FootPlane plane = FootLine(fold, 1).at(1);
  EXPECT_NEAR(plane.normal.norm(), 1, 1e-6);
}

}  // namespace
}  // namespace burin
