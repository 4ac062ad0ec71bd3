#include <burin/stroke/curve/pen_path.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace burin {
namespace {

constexpr double path_radius = 1, least_step = 0.0005;

PenKnot at(double x, double y, double time = 0, float pressure = 1) {
  PenKnot sample;
  sample.ground_point.at.position = Vec3f(static_cast<float>(x), static_cast<float>(y), 0);
  sample.time = time;
  sample.pen.pressure = pressure;
  return sample;
}

/// A pen and the knots that its samples left.
struct Drawn {
  PenPath path{path_radius, least_step};
  std::vector<PenKnot> knots;

  PenPath::Change to(const PenKnot& sample) { return path.add(knots, sample); }
  double length() const {
    double length = 0;
    for (std::size_t i = 1; i < knots.size(); ++i)
      length += static_cast<double>((knots[i].position() - knots[i - 1].position()).norm());
    return length;
  }
  double farthest_from(double x, double y) const {
    double farthest = 0;
    for (const PenKnot& knot : knots)
      farthest = std::max<double>(farthest, (knot.position() - at(x, y).position()).norm());
    return farthest;
  }
};

/// Every sample counts, and is shown at once.
void expect_exact(const std::vector<PenKnot>& samples) {
  Drawn drawn;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(drawn.to(samples[i]), PenPath::Change::path) << i;
    ASSERT_EQ(drawn.knots.size(), i + 1);
    for (std::size_t k = 0; k <= i; ++k)
      ASSERT_EQ(drawn.knots[k].position(), samples[k].position()) << i << " " << k;
  }
}

/// Samples of a way by its length, this far apart.
std::vector<PenKnot> sampled(double length, double step, const std::function<Vec2d(double)>& way) {
  std::vector<PenKnot> samples;
  for (int i = 0; i * step <= length; ++i) samples.push_back(at(way(i * step).x(), way(i * step).y()));
  return samples;
}

TEST(PenPath, TakesEverySampleOfAPenThatMoves) {
  for (const double step : {0.0006, 0.004, 0.03, 0.2, 1.5}) {
    expect_exact(sampled(80 * step, step, [](double t) { return Vec2d(t, 0); }));
    expect_exact(sampled(80 * step, step, [](double t) { return Vec2d(std::cos(2 * t), std::sin(2 * t)); }));
  }
  // A loop smaller than the radius, and a spiral.
  expect_exact(
      sampled(1, 0.01, [](double t) -> Vec2d { return 0.1 * Vec2d(std::cos(10 * t), std::sin(10 * t)); }));
  expect_exact(sampled(
      2, 0.01, [](double t) -> Vec2d { return (0.1 + 0.2 * t) * Vec2d(std::cos(9 * t), std::sin(9 * t)); }));
}

TEST(PenPath, TakesEverySampleAtCornersAndOfAWayBack) {
  for (const double step : {0.0006, 0.004, 0.03, 0.06, 0.2}) {
    const double middle = 40 * step;
    const auto turned = [&](double degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      return [=](double t) {
        const double beyond = std::max(t - middle, 0.);
        return Vec2d(std::min(t, middle) + beyond * std::cos(angle), beyond * std::sin(angle));
      };
    };
    for (const double degrees : {60., 91., 120., 150., 180.})
      expect_exact(sampled(80 * step, step, turned(degrees)));
  }
}

/// An even pen that rests half way and trembles by a hundredth of the radius.
Drawn rested(int samples, const std::function<Vec2d(int)>& tremble) {
  Drawn drawn;
  for (int i = 0; i <= 20; ++i) drawn.to(at(0.03 * i, 0));
  for (int i = 0; i < samples; ++i) drawn.to(at(0.6 + tremble(i).x(), tremble(i).y()));
  for (int i = 1; i <= 20; ++i) drawn.to(at(0.6 + 0.03 * i, 0));
  return drawn;
}

TEST(PenPath, LeavesOutATrembleAtRest) {
  std::mt19937 random(7);
  std::normal_distribution<double> offset(0, 0.007);
  const Drawn shaking = rested(500, [&](int) { return Vec2d(offset(random), offset(random)); });
  EXPECT_LT(shaking.length(), 1.2 + 0.15);
  const Drawn circling =
      rested(500, [](int i) -> Vec2d { return 0.01 * Vec2d(std::sin(0.4 * i), 1 - std::cos(0.4 * i)); });
  EXPECT_LT(circling.length(), 1.2 + 0.15);
  const Drawn wagging = rested(500, [](int i) { return Vec2d(0, 0.01 * std::sin(0.3 * i)); });
  EXPECT_LT(wagging.length(), 1.2 + 0.15);
  EXPECT_LT(wagging.knots.size(), 80u);
}

TEST(PenPath, GoesOnOnceThePenLeftItsRestForGood) {
  Drawn drawn;
  for (int i = 0; i <= 10; ++i) drawn.to(at(0.1 * i, 0));
  for (const double x : {0.99, 1.01, 0.985}) drawn.to(at(x, 0));
  const std::size_t resting = drawn.knots.size();
  EXPECT_EQ(resting, 11u);
  drawn.to(at(1.03, 0.02));
  EXPECT_EQ(drawn.knots.size(), resting) << "a twentieth of the radius is the least that leads on";
  drawn.to(at(1.04, 0.04));
  ASSERT_EQ(drawn.knots.size(), resting + 1);
  EXPECT_EQ(drawn.knots.back().position(), at(1.04, 0.04).position()) << "and only the last sample counts";
  drawn.to(at(1.05, 0.05));
  EXPECT_EQ(drawn.knots.size(), resting + 2) << "from then on all do";
}

TEST(PenPath, MakesADabOfARestAlone) {
  std::mt19937 random(3);
  std::normal_distribution<double> offset(0, 0.005);
  Drawn drawn;
  for (int i = 0; i < 1000; ++i) drawn.to(at(offset(random), offset(random)));
  EXPECT_LT(drawn.farthest_from(0, 0), 0.05);
  EXPECT_LT(drawn.length(), 0.15);
}

TEST(PenPath, LeavesNoMoreOfASlowPenThanOfAFastOne) {
  Drawn drawn;
  for (int i = 0; i <= 20000; ++i) drawn.to(at(1e-5 * i, 0, i));
  EXPECT_LE(drawn.knots.size(), 0.2 / least_step + 2);
  EXPECT_GT(drawn.knots.size(), 0.8 * 0.2 / least_step);
  EXPECT_NEAR(drawn.knots.back().position().x(), 0.2, 1.1 * least_step);
  for (std::size_t i = 1; i < drawn.knots.size(); ++i)
    EXPECT_NEAR(drawn.knots[i].time - drawn.knots[i - 1].time, 50, 2) << "times of arrival " << i;
}

TEST(PenPath, TakesThePenOfSamplesThatDoNotCount) {
  Drawn drawn;
  drawn.to(at(0, 0, 0, 0.1F));
  EXPECT_EQ(drawn.to(at(1e-6, 0, 1, 0.5F)), PenPath::Change::pen);
  EXPECT_EQ(drawn.to(at(0, 1e-6, 2, 0.5F)), PenPath::Change::none);
  ASSERT_EQ(drawn.knots.size(), 1u);
  EXPECT_EQ(drawn.knots[0].pen.pressure, 0.5F);
  EXPECT_EQ(drawn.knots[0].position(), Vec3f::Zero());
  EXPECT_EQ(drawn.to(at(0, 0, 3, 0.7F)), PenPath::Change::pen);
  EXPECT_EQ(drawn.knots[0].time, 3) << "in the very place";
  EXPECT_EQ(drawn.knots[0].pen.pressure, 0.7F);
}

TEST(PenPath, DependsOnTheSamplesSoFarAlone) {
  std::mt19937 random(5);
  std::normal_distribution<double> offset(0, 0.02);
  std::vector<PenKnot> samples;
  for (int i = 0; i < 300; ++i) samples.push_back(at(0.01 * i + offset(random), offset(random)));
  Drawn whole;
  std::size_t taken = 0;
  std::vector<PenKnot> before;
  for (const PenKnot& sample : samples) {
    whole.to(sample);
    EXPECT_GE(whole.path.taken(), taken);
    for (std::size_t i = 0; i < taken; ++i)
      EXPECT_EQ(whole.knots[i].position(), before[i].position()) << "what was taken stays";
    taken = whole.path.taken();
    before = whole.knots;
  }
}

}  // namespace
}  // namespace burin
