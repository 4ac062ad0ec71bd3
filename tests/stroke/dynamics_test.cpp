#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/dynamics.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/shapes.h"

namespace burin {
namespace {

using std::numbers::pi;

const PenFields all_fields{.time = true, .pressure = true, .tilt = true, .twist = true};
const DrivenStroke stroke{.fields = all_fields, .radius = 0.5, .seed = 7};
/// The identity, from far below to far above all values of a source.
const std::vector<double> identity{-1000, -1000, 1000, 1000};

double value_of(PenSource source, const PenAt& at) {
  return TargetDynamics(std::vector<Dynamic>{{"x", source, identity}}, "x", stroke).product(at, 0);
}

PenAt some_place() {
  PenAt at;
  at.pen = {.pressure = 0.25F, .tilt_x = 0.3F, .tilt_y = -0.4F};
  at.time = 3;
  at.speed = 2;
  at.t = 1.75;
  at.tangent = Vec3f(0, 2, 0);
  at.normal = Vec3f(0, 0, 0.5F);
  return at;
}

TEST(Dynamics, TakeEverySourceInItsUnits) {
  const PenAt at = some_place();
  EXPECT_NEAR(value_of(PenSource::pressure, at), 0.25, 1e-9);
  const Vec3d upper_end(std::tan(0.3), -std::tan(0.4), 1);
  EXPECT_NEAR(value_of(PenSource::tilt, at), std::acos(1 / upper_end.norm()), 1e-6);
  EXPECT_NEAR(value_of(PenSource::tilt_direction, at), std::atan2(upper_end.y(), upper_end.x()), 1e-6);
  EXPECT_NEAR(value_of(PenSource::direction, at), pi / 2, 1e-6);
  EXPECT_NEAR(value_of(PenSource::speed, at), 4, 1e-9);
  EXPECT_NEAR(value_of(PenSource::time, at), 3, 1e-9);
  EXPECT_NEAR(value_of(PenSource::t, at), 3.5, 1e-9);
  EXPECT_EQ(value_of(PenSource::tilt_direction, PenAt{}), 0) << "an upright pen";
}

TEST(Dynamics, KnowSourcesByName) {
  for (const char* name :
       {"pressure", "tilt", "tilt_direction", "direction", "speed", "time", "t", "random"}) {
    ASSERT_TRUE(parse_source(name)) << name;
    EXPECT_EQ(source_name(*parse_source(name)), name);
  }
  EXPECT_FALSE(parse_source("Pressure"));
  EXPECT_EQ(source_names(), "pressure, tilt, tilt_direction, direction, speed, time, t, random");
}

TEST(Dynamics, RunStraightBetweenKnotsAndLevelBeyond) {
  const std::vector<Dynamic> dynamics{{"x", PenSource::time, {1, 2, 2, 4, 4, -1}}};
  const TargetDynamics target(dynamics, "x", stroke);
  const double expected[][2] = {{0, 2}, {1, 2}, {1.25, 2.5}, {2, 4}, {3, 1.5}, {4, -1}, {9, -1}};
  for (const auto& [time, value] : expected) {
    PenAt at;
    at.time = time;
    EXPECT_DOUBLE_EQ(target.product(at, 0), value) << time;
    EXPECT_DOUBLE_EQ(target.sum(at, 0), value) << time;
  }
  EXPECT_DOUBLE_EQ(target.product(some_place(), 0, 0, 1), 1) << "held within bounds";
}

TEST(Dynamics, ActTogetherOnOneTargetAlone) {
  const std::vector<Dynamic> dynamics{{"x", PenSource::pressure, {0, 1, 1, 3}},
                                      {"y", PenSource::time, {0, 100}},
                                      {"x", PenSource::time, {0, 0, 10, 5}}};
  const TargetDynamics target(dynamics, "x", stroke);
  EXPECT_DOUBLE_EQ(target.product(some_place(), 0), 1.5 * 1.5);
  EXPECT_DOUBLE_EQ(target.sum(some_place(), 0), 3);
  const TargetDynamics none(dynamics, "z", stroke);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.product(some_place(), 0), 1);
  EXPECT_EQ(none.sum(some_place(), 0), 0);
}

TEST(Dynamics, LeaveAloneWhatTheRecordingCannotDrive) {
  const auto drives = [](PenSource source, const PenFields& fields) {
    return !TargetDynamics(std::vector<Dynamic>{{"x", source, {0, 7}}}, "x", {.fields = fields}).empty();
  };
  EXPECT_FALSE(drives(PenSource::pressure, {.time = true, .tilt = true, .twist = true}));
  EXPECT_FALSE(drives(PenSource::tilt, {.time = true, .pressure = true, .twist = true}));
  EXPECT_FALSE(drives(PenSource::tilt_direction, {.time = true, .pressure = true}));
  EXPECT_FALSE(drives(PenSource::speed, {.pressure = true, .tilt = true}));
  EXPECT_FALSE(drives(PenSource::time, {.pressure = true, .tilt = true}));
  EXPECT_TRUE(drives(PenSource::speed, {.time = true}));
  EXPECT_TRUE(drives(PenSource::tilt, {.tilt = true}));
  for (const PenSource source : {PenSource::direction, PenSource::t, PenSource::random})
    EXPECT_TRUE(drives(source, {}));
}

TEST(Dynamics, StayFiniteHoweverManyMultiply) {
  const std::vector<Dynamic> dynamics(12, {"x", PenSource::time, {0, 3e38}});
  EXPECT_EQ(TargetDynamics(dynamics, "x", stroke).product(some_place(), 0),
            double{std::numeric_limits<float>::max()});
}

TEST(Dynamics, ReplaceThoseOfTheSameTarget) {
  const Dynamic a{"a", PenSource::t, {0, 1}}, b{"b", PenSource::t, {0, 1}}, b2{"b", PenSource::time, {0, 2}};
  EXPECT_EQ(replaced({b, a, b}, {b2}), (std::vector<Dynamic>{a, b2}));
  EXPECT_EQ(replaced({a}, {}), (std::vector<Dynamic>{a}));
  EXPECT_EQ(replaced({}, {b, b2}), (std::vector<Dynamic>{b, b2}));
}

TEST(TravelDirection, TurnsCounterClockwiseSeenFromOutside) {
  for (double angle = -3; angle < 3.1; angle += 0.5) {
    const Vec3f along(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0);
    EXPECT_NEAR(travel_direction(along, Vec3f::UnitZ()), angle, 1e-6);
    EXPECT_NEAR(travel_direction(along, -Vec3f::UnitZ()), -angle, 1e-6);
  }
  EXPECT_NEAR(travel_direction(Vec3f::UnitZ(), -Vec3f::UnitY()), pi / 2, 1e-6);
  EXPECT_NEAR(travel_direction(Vec3f::UnitZ(), Vec3f::UnitX()), pi / 2, 1e-6) << "from the y axis";
}

double noise_at(double t, double loop, std::uint64_t seed = 7, const std::string& target = "x") {
  PenAt at;
  at.t = t;
  return TargetDynamics(std::vector<Dynamic>{{target, PenSource::random, identity}}, target,
                        {.fields = all_fields, .radius = 0.5, .seed = seed})
      .product(at, loop);
}

TEST(RandomSource, IsSmoothNoiseOfOneValueARadius) {
  double mean = 0, squares = 0;
  constexpr int cells = 4000;
  for (int cell = 0; cell < cells; ++cell) {
    const double value = noise_at(0.5 * cell, 0), next = noise_at(0.5 * (cell + 1), 0);
    ASSERT_TRUE(value >= 0 && value < 1);
    mean += value / cells;
    squares += value * value / cells;
    EXPECT_NEAR(noise_at(0.5 * (cell + 0.5), 0), (value + next) / 2, 1e-9);
    EXPECT_NEAR(noise_at(0.5 * cell + 0.0005, 0), value, 4e-6) << "level at the border of a cell";
    EXPECT_NEAR(noise_at(0.5 * cell - 0.0005, 0), value, 4e-6);
  }
  EXPECT_NEAR(mean, 0.5, 0.02);
  EXPECT_NEAR(squares, 1. / 3, 0.02);
}

TEST(RandomSource, DiffersByStrokeAndTargetOnly) {
  int other_seed = 0, other_target = 0;
  for (double t = 0.1; t < 20; t += 0.5) {
    EXPECT_EQ(noise_at(t, 0), noise_at(t, 0));
    other_seed += std::abs(noise_at(t, 0) - noise_at(t, 0, 8)) > 0.01;
    other_target += std::abs(noise_at(t, 0) - noise_at(t, 0, 7, "y")) > 0.01;
  }
  EXPECT_GT(other_seed, 30);
  EXPECT_GT(other_target, 30);
}

TEST(RandomSource, ClosesAroundALoop) {
  for (const double loop : {10.1, 9.9, 0.2}) {
    EXPECT_NEAR(noise_at(loop - 1e-6, loop), noise_at(0, loop), 1e-9) << loop;
    EXPECT_NEAR(noise_at(loop / 3, loop), noise_at(loop / 3 + loop, loop), 1e-6);
  }
  EXPECT_GT(std::abs(noise_at(10 - 1e-6, 0) - noise_at(0, 0)), 1e-3) << "an open stroke has two ends";
}

TEST(StrokeWidthTest, FollowsPressureAndDynamicsWithinBounds) {
  const auto width = [](double pressure_width, float pressure, const std::vector<double>& curve) {
    PenAt at;
    at.pen.pressure = pressure;
    return StrokeWidth(pressure_width, std::vector<Dynamic>{{"radius", PenSource::pressure, curve}}, stroke)
        .at(at, 0);
  };
  EXPECT_EQ(width(0.5, 0.25F, {0, 1}), 0.625F);
  EXPECT_EQ(width(0.5, 0.5F, {0, 0.5, 1, 1.5}), 0.75F);
  EXPECT_EQ(width(0, 0.25F, {0, 0, 1, 1}), 0.25F);
  EXPECT_EQ(width(0, 0, {0, 0, 1, 1}), 0.02F);
  EXPECT_EQ(width(0, 1, {0, -5, 1, -1}), 0.02F);
  EXPECT_EQ(width(0, 1, {0, 9}), 1) << "no wider than the chart";
  EXPECT_EQ(width(1, 0.03F, {0, 0.1}), 0.02F) << "the product too";
}

TEST(StrokeWidthTest, KnowsItsNarrowest) {
  const PenFields mouse{.time = true};
  const std::vector<Dynamic> dynamics{{"radius", PenSource::pressure, {0, 0.5, 1, 0.75}},
                                      {"radius", PenSource::t, {0, 3, 1, 0.5, 2, 2}}};
  EXPECT_EQ(StrokeWidth().narrowest(), 1);
  EXPECT_FALSE(StrokeWidth().varies());
  EXPECT_EQ(StrokeWidth(0.5, {}, stroke).narrowest(), 0.5);
  EXPECT_EQ(StrokeWidth(1, {}, stroke).narrowest(), 0.02);
  EXPECT_EQ(StrokeWidth(0.5, dynamics, stroke).narrowest(), 0.125);
  EXPECT_EQ(StrokeWidth(0.5, dynamics, {.fields = mouse}).narrowest(), 0.5) << "no pressure";
  EXPECT_FALSE(StrokeWidth(0.5, {}, {.fields = mouse}).varies());
}

}  // namespace
}  // namespace burin
