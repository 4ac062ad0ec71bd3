#include <burin/stroke/stabiliser.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "stroke/recordings.h"

namespace burin {
namespace {

using Kind = Stabilising::Kind;

Sample sample_at(double time, const Vec3d& place, float pressure = 1) {
  return {time, place, {.pressure = pressure}};
}

TEST(Stabiliser, LetsSamplesThroughWhenOff) {
  Stabiliser off({});
  for (int i = 0; i < 5; ++i) {
    const Sample sample = sample_at(i, {0.1 * i * i, -i / 3., 2}, 0.2F * static_cast<float>(i));
    EXPECT_TRUE(test::same_bits(off.add(sample), sample));
  }
  EXPECT_FALSE(off.finish());
  EXPECT_FALSE(Stabiliser({Kind::string, 1}).finish()) << "no sample";
}

TEST(PulledString, FollowsTheTractrix) {
  // The pen goes up the y axis, the brush begins on the x axis at the length of the string. The tractrix:
  // x = L / cosh(y_pen / L), y = y_pen - L tanh(y_pen / L).
  constexpr double length = 0.5;
  for (const int steps : {1, 7, 400}) {
    Stabiliser string({Kind::string, length});
    string.add(sample_at(0, {length, 0, 3}));
    Sample brush = string.add(sample_at(0, {0, 0, 3}));  // slack: the string is just taut now
    EXPECT_EQ(brush.position, Vec3d(length, 0, 3));
    for (int i = 1; i <= steps; ++i) {
      const double y = 2. * i / steps;
      brush = string.add(sample_at(i, {0, y, 3}));
      EXPECT_NEAR(brush.position.x(), length / std::cosh(y / length), 1e-12);
      EXPECT_NEAR(brush.position.y(), y - length * std::tanh(y / length), 1e-12);
      EXPECT_EQ(brush.position.z(), 3);
    }
  }
}

TEST(PulledString, LeavesTheBrushWhereItIsWhileSlack) {
  Stabiliser string({Kind::string, 1});
  string.add(sample_at(0, {0, 0, 0}));
  EXPECT_EQ(string.add(sample_at(1, {0.6, 0.6, 0})).position, Vec3d(0, 0, 0));
  EXPECT_EQ(string.add(sample_at(2, {0, 0, 0})).position, Vec3d(0, 0, 0));
  EXPECT_LT((string.add(sample_at(3, {3, 0, 0})).position - Vec3d(2, 0, 0)).norm(), 1e-15)
      << "straight behind";
  EXPECT_LT((string.add(sample_at(4, {2, 0, 0})).position - Vec3d(2, 0, 0)).norm(), 1e-15) << "back onto it";
  EXPECT_LT((string.add(sample_at(5, {0, 0, 0})).position - Vec3d(1, 0, 0)).norm(), 1e-15) << "and beyond";
}

TEST(PulledString, KeepsTimeAndPen) {
  Stabiliser string({Kind::string, 1});
  string.add(sample_at(5, {0, 0, 0}, 0.1F));
  const Sample brush = string.add(sample_at(6, {3, 1, 0}, 0.7F));
  EXPECT_EQ(brush.time, 6);
  EXPECT_EQ(brush.pen.pressure, 0.7F);
}

TEST(ExponentialStabiliser, RespondsToARampExactly) {
  // The response to a pen that moves from 0 at speed v is v (t - tau (1 - exp(-t / tau))).
  constexpr double tau = 0.1, v = 3;
  for (const int steps : {1, 13, 500}) {
    Stabiliser lag({Kind::exponential, tau});
    lag.add(sample_at(2, {0, 0, 0}, 0));
    for (int i = 1; i <= steps; ++i) {
      const double t = 0.3 * i / steps, lagging = t - tau * -std::expm1(-t / tau);
      const Sample brush = lag.add(sample_at(2 + t, {v * t, 0, -t}, static_cast<float>(t)));
      EXPECT_NEAR(brush.position.x(), v * lagging, 1e-12);
      EXPECT_NEAR(brush.position.z(), -lagging, 1e-12);
      EXPECT_NEAR(brush.pen.pressure, lagging, 1e-6) << "the pen lags alike";
      EXPECT_EQ(brush.time, 2 + t);
    }
  }
}

TEST(ExponentialStabiliser, RespondsToAStepExactly) {
  for (const int rate : {60, 240}) {
    Stabiliser lag({Kind::exponential, 0.2});
    lag.add(sample_at(0, {0, 0, 0}));
    EXPECT_EQ(lag.add(sample_at(0, {1, 0, 0})).position, Vec3d(0, 0, 0)) << "no time has gone by";
    for (int i = 1; i <= rate; ++i) {
      const double time = static_cast<double>(i) / rate;
      EXPECT_NEAR(lag.add(sample_at(time, {1, 0, 0})).position.x(), 1 - std::exp(-time / 0.2), 1e-12);
    }
  }
}

/// The brush at the full tenths of a second of one second, and its last place after all.
std::vector<Vec3d> drawn_at(int rate, const Stabilising& stabilising) {
  Stabiliser stabiliser(stabilising);
  std::vector<Vec3d> places;
  for (int i = 0; i <= rate; ++i) {
    const double s = static_cast<double>(i) / rate;
    const Sample brush = stabiliser.add(sample_at(s, {2 * s, std::sin(6 * s), 0.3 * s * s}));
    if (i % (rate / 10) == 0) places.push_back(brush.position);
  }
  places.push_back(stabiliser.finish()->position);
  return places;
}

TEST(Stabiliser, DrawsTheSameAtAnyRate) {
  // The tolerance is the sagitta of the pen's path between samples: 36 / 60^2 / 8 = 0.0013.
  for (const Stabilising stabilising : {Stabilising{Kind::string, 0.3}, {Kind::exponential, 0.05}}) {
    const auto seldom = drawn_at(60, stabilising), often = drawn_at(240, stabilising);
    ASSERT_EQ(seldom.size(), 12u);
    for (std::size_t i = 0; i < seldom.size(); ++i) EXPECT_LT((seldom[i] - often[i]).norm(), 0.0013) << i;
  }
}

TEST(Stabiliser, EndsWhereThePenEnded) {
  for (const Stabilising stabilising : {Stabilising{Kind::string, 0.3}, {Kind::exponential, 0.05}}) {
    std::vector<Sample> samples;
    for (int i = 0; i <= 60; ++i)
      samples.push_back(sample_at(i / 60., {i / 30., 0, 0}, static_cast<float>(i) / 60));
    const std::vector<Sample> calm = stabilised(samples, stabilising);
    ASSERT_EQ(calm.size(), samples.size() + 1);
    const Sample &brush = calm[60], &last = calm[61];
    EXPECT_GT((brush.position - samples.back().position).norm(), 0.05);
    EXPECT_EQ(last.position, samples.back().position);
    EXPECT_EQ(last.pen.pressure, 1);
    const double mean_speed = (brush.position - samples[0].position).norm() / brush.time;
    EXPECT_NEAR((last.position - brush.position).norm() / (last.time - brush.time), mean_speed, 1e-9);
  }
  const std::vector<Sample> slack = {sample_at(1, {0, 0, 0}), sample_at(2, {0.1, 0, 0})};
  const std::vector<Sample> calm = stabilised(slack, {Kind::string, 1});
  ASSERT_EQ(calm.size(), 3u) << "too short to pull the string taut";
  EXPECT_EQ(calm[2].position, Vec3d(0.1, 0, 0));
  EXPECT_EQ(calm[2].time, 2);
  EXPECT_EQ(stabilised(std::span(slack).first(1), {Kind::string, 1}).size(), 1u) << "a dot stays one";
}

TEST(ExponentialMean, TurnsTheBarrelTheShorterWay) {
  Stabiliser mean({Kind::exponential, 0.1});
  constexpr float degree = std::numbers::pi_v<float> / 180;
  for (int i = 0; i <= 40; ++i) {
    const auto twist = static_cast<float>((340 + i) % 360);
    const Sample calm = mean.add({0.01 * i, {0.1 * i, 0, 0}, {.twist = twist * degree}});
    EXPECT_TRUE(calm.pen.twist >= 339.99F * degree || calm.pen.twist <= 20 * degree) << i;
  }
}

TEST(ExponentialMean, KeepsAFlatPenFlat) {
  Stabiliser mean({Kind::exponential, 0.1});
  constexpr float flat = std::numbers::pi_v<float> / 2;
  for (int i = 0; i < 5; ++i) {
    const Pen calm = mean.add({0.01 * i, {0.1 * i, 0, 0}, {.tilt_x = flat}}).pen;
    EXPECT_EQ(calm.tilt_x, flat);
    EXPECT_EQ(calm.tilt_y, 0);
  }
}

}  // namespace
}  // namespace burin
