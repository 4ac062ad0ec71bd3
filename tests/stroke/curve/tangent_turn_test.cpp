#include <burin/stroke/curve/tangent_turn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/closed_curve.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

constexpr double latitude = 0.5;

SurfaceCurve eastwards(double angle) {
  const Surface surface = make_surface(test::sphere(6, 0.15, 4));
  const Picker picker(surface);
  return test::traced(surface, picker, 0.2, test::sampled(200, [=](double s) {
                        return Vec3d(std::cos(latitude) * std::cos(angle * s),
                                     std::cos(latitude) * std::sin(angle * s), std::sin(latitude));
                      }));
}

// A circle of latitude has the geodesic curvature tan(latitude), and the length of an arc is
// cos(latitude) angle.
TEST(TangentTurn, AlongACircleOfLatitudeIsTheSineOfTheLatitudeTimesTheAngle) {
  const SurfaceCurve curve = eastwards(1.5);
  TangentTurn turn;
  turn.update(curve);
  EXPECT_EQ(turn.at(0), 0);
  const double rate = std::tan(latitude);
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    EXPECT_NEAR(turn.at(i), rate * curve.points[i].t, 0.02) << i;
}

// By Gauss and Bonnet it is 2 pi less the area of the cap.
TEST(TangentTurn, AroundACircleOfLatitudeIsAFullTurnLessTheAreaOfTheCap) {
  constexpr double pi = std::numbers::pi;
  SurfaceCurve curve = eastwards(2 * pi);
  test::close(curve);
  TangentTurn turn;
  turn.update(curve);
  EXPECT_NEAR(turn.loop(), 2 * pi * std::sin(latitude), 0.02);
}

TEST(TangentTurn, FollowsAGrowingCurveBitForBit) {
  const SurfaceCurve whole = eastwards(1.5);
  TangentTurn growing, fresh;
  SurfaceCurve curve;
  curve.points.assign(whole.points.begin(), whole.points.begin() + 20);
  growing.update(curve);
  curve.points.resize(15);
  curve.points.insert(curve.points.end(), whole.points.begin() + 15, whole.points.begin() + 60);
  growing.update(curve, 15);
  fresh.update(curve);
  for (std::size_t i = 0; i < curve.points.size(); ++i) EXPECT_EQ(growing.at(i), fresh.at(i)) << i;
}

}  // namespace
}  // namespace burin
