#include <burin/stroke/curve/pen_spline.h>
#include <burin/stroke/dynamics.h>
#include <burin/stroke/pen_angles.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace burin {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

Pen tilted(double x, double y) {
  return {.tilt_x = static_cast<float>(x * degree), .tilt_y = static_cast<float>(y * degree)};
}

Pen twisted(double degrees) { return {.twist = static_cast<float>(degrees * degree)}; }

double azimuth(const Pen& pen) {
  const Vec3d end = upper_end(pen);
  return std::atan2(end.y(), end.x()) / degree;
}

/// The angle between two directions, degrees.
double between(const Vec3d& a, const Vec3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) / degree; }

/// A pen of this azimuth and altitude, degrees.
Pen leaning(double azimuth, double altitude) {
  Pen pen;
  set_upper_end(pen, {std::cos(altitude * degree) * std::cos(azimuth * degree),
                      std::cos(altitude * degree) * std::sin(azimuth * degree), std::sin(altitude * degree)});
  return pen;
}

double sourced(PenSource source, const Pen& pen) {
  const std::vector<Dynamic> identity{{"x", source, {-1000, -1000, 1000, 1000}}};
  PenAt at;
  at.pen = pen;
  return TargetDynamics(identity, "x", {.fields = {.tilt = true}}).product(at, 0) / degree;
}

TEST(PenAngles, PointToTheUpperEnd) {
  EXPECT_EQ(upper_end({}), Vec3d(0, 0, 1));
  const Vec3d end(std::tan(20 * degree), std::tan(-50 * degree), 1);
  EXPECT_LT(between(upper_end(tilted(20, -50)), end), 1e-5);
  Pen pen;
  set_upper_end(pen, 7 * end);
  EXPECT_NEAR(pen.tilt_x, 20 * degree, 1e-6);
  EXPECT_NEAR(pen.tilt_y, -50 * degree, 1e-6);
}

TEST(PenAngles, SurviveAPenThatLiesFlat) {
  EXPECT_NEAR(azimuth(tilted(90, 0)), 0, 1e-5);
  EXPECT_NEAR(azimuth(tilted(-90, 10)), 180, 1e-5);
  EXPECT_NEAR(azimuth(tilted(0, 90)), 90, 1e-5);
  EXPECT_NEAR(azimuth(tilted(30, -90)), -90, 1e-5);
  EXPECT_NEAR(azimuth(tilted(90, 90)), 45, 1e-5);
  EXPECT_NEAR(azimuth(tilted(100, 0)), 0, 1e-5) << "beyond 90 degrees";
  for (double towards = -170; towards <= 180; towards += 35) {
    EXPECT_NEAR(azimuth(leaning(towards, 0)), towards, 0.01);
    EXPECT_LT(
        between(upper_end(leaning(towards, 0)), {std::cos(towards * degree), std::sin(towards * degree), 0}),
        0.06);
  }
}

TEST(PenAngles, DriveDynamicsOfAPenThatLiesFlat) {
  EXPECT_NEAR(sourced(PenSource::tilt_direction, tilted(90, 0)), 0, 1e-5);
  EXPECT_NEAR(sourced(PenSource::tilt_direction, tilted(0, 90)), 90, 1e-5);
  EXPECT_NEAR(sourced(PenSource::tilt_direction, tilted(90, 90)), 45, 1e-5);
  EXPECT_NEAR(sourced(PenSource::tilt, tilted(90, 0)), 90, 1e-5);
  EXPECT_NEAR(sourced(PenSource::tilt, tilted(0, -90)), 90, 1e-5);
}

TEST(PenAngles, TakeWholeTurnsOffTwists) {
  EXPECT_NEAR(twist_near(10 * degree, 350 * degree), 370 * degree, 1e-12);
  EXPECT_NEAR(twist_near(350 * degree, 10 * degree), -10 * degree, 1e-12);
  EXPECT_EQ(twist_near(1.25, 2), 1.25) << "to the bit where nothing is to be taken off";
  EXPECT_NEAR(twist_near(0.5, 0.4 + 20 * pi), 0.5 + 20 * pi, 1e-12);
  EXPECT_EQ(wrap_twist(0.1F), 0.1F);
  EXPECT_NEAR(wrap_twist(-0.5), 2 * pi - 0.5, 1e-6);
  EXPECT_NEAR(wrap_twist(15), 15 - 4 * pi, 1e-6);
  EXPECT_GE(wrap_twist(-1e-9), 0);
  EXPECT_LT(double{wrap_twist(-1e-9)}, 2 * pi);
}

TEST(PenAngles, GoTheShorterWayBetweenPens) {
  const Pen across = pen_between(twisted(350), twisted(10), 0.25F);
  EXPECT_NEAR(across.twist / degree, 355, 1e-4);
  EXPECT_NEAR(pen_between(twisted(10), twisted(350), 0.75F).twist / degree, 355, 1e-4);
  EXPECT_NEAR(pen_between(twisted(350), twisted(10), 0.75F).twist / degree, 5, 1e-4);
  const Pen round = pen_between(leaning(0, 1), leaning(90, 1), 0.5F);
  EXPECT_NEAR(azimuth(round), 45, 0.01);
  EXPECT_LT(std::acos(upper_end(round).head<2>().norm()) / degree, 2) << "the pen does not rise on the way";
}

/// Whatever the cubic of these pens, it keeps to what holds(pen) tells all along.
template <class Holds>
void expect_between(const Pen& first, const Pen& from, const Pen& to, const Pen& last, const Holds& holds) {
  const PenCubic cubic({1, 1, 1}, first, from, to, last);
  for (double s = 0; s <= 1; s += 0.125) EXPECT_TRUE(holds(cubic.at(s))) << s;
}

TEST(PenCubic, TurnsTheBarrelTheShorterWay) {
  const auto near_seam = [](const Pen& pen) {
    const double degrees = pen.twist / degree;
    return degrees >= 349.999 || degrees <= 10.001;
  };
  expect_between(twisted(330), twisted(350), twisted(10), twisted(30), near_seam);
  expect_between(twisted(30), twisted(10), twisted(350), twisted(330), near_seam);
  const PenCubic even({1, 1, 1}, twisted(330), twisted(350), twisted(10), twisted(30));
  EXPECT_NEAR(even.at(0.25).twist / degree, 355, 1e-3);
  EXPECT_NEAR(even.at(0.75).twist / degree, 5, 1e-3);
}

TEST(PenCubic, LeadsTheTiltAsADirection) {
  const PenCubic cubic({1, 1, 1}, leaning(90, 20), leaning(120, 20), leaning(150, 20), leaning(180, 20));
  EXPECT_NEAR(azimuth(cubic.at(0.5)), 135, 1e-3);
  EXPECT_NEAR(std::asin(upper_end(cubic.at(0.5)).z()) / degree, 20, 1);
  const Pen flat = tilted(90, 0);
  const Pen still = PenCubic({1, 1, 1}, flat, flat, flat, flat).at(0.4);
  EXPECT_TRUE(same_tilt(still, flat)) << "to the bit";
  expect_between(leaning(0, 0), leaning(30, 0), leaning(60, 0), leaning(90, 0), [](const Pen& pen) {
    return azimuth(pen) > 29.9 && azimuth(pen) < 60.1 && upper_end(pen).z() < 0.2;
  });
}

}  // namespace
}  // namespace burin
