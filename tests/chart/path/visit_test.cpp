// Tests visits of a stroke to a vertex, with strokes in the plane.
#include <burin/chart/path/visit.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace burin {
namespace {

constexpr double visit_radius = 1;

SurfaceCurve curve_through(const std::vector<Vec2d>& places, bool closed = false) {
  SurfaceCurve curve;
  double t = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0) t += (places[i] - places[i - 1]).norm();
    CurvePoint point{};
    point.at.position = Vec3f(static_cast<float>(places[i].x()), static_cast<float>(places[i].y()), 0);
    point.normal = Vec3f::UnitZ();
    point.tangent = Vec3f::UnitX();
    point.t = t;
    point.width = 1;
    curve.points.push_back(point);
  }
  curve.closed = closed;
  if (closed) curve.closing_length = (places.front() - places.back()).norm();
  return curve;
}

StrokeSamples samples_of(const std::vector<Vec2d>& places, bool closed = false) {
  StrokeSamples samples;
  samples.update(curve_through(places, closed), visit_radius, 1e-6, {}, 0);
  return samples;
}

/// Two legs that are `apart`, along x from 0 to 4 and back, with a half circle between them.
std::vector<Vec2d> hairpin(double apart) {
  std::vector<Vec2d> places;
  for (int i = 0; i < 80; ++i) places.emplace_back(0.05 * i, 0);
  for (int i = 0; i <= 20; ++i) {
    const double angle = std::numbers::pi * i / 20;
    places.emplace_back(4 + apart / 2 * std::sin(angle), apart / 2 * (1 - std::cos(angle)));
  }
  for (int i = 79; i >= 0; --i) places.emplace_back(0.05 * i, apart);
  return places;
}

std::vector<Visit> visits_to(const StrokeSamples& samples, const Vec2d& x) {
  const Visits visits(samples, Vec3f(static_cast<float>(x.x()), static_cast<float>(x.y()), 0),
                      Vec3f::UnitZ());
  std::vector<Visit> all;
  for (Index sample = 0; sample < samples.size(); ++sample) {
    if (!visits.any(sample)) continue;
    const Visit visit = visits.find(sample, 0).visit;
    if (all.empty() || all.back().begin != visit.begin) all.push_back(visit);
  }
  return all;
}

TEST(Visits, AreRunsInReachOfAStraightStroke) {
  const StrokeSamples samples = samples_of({{0, 0}, {10, 0}});
  const std::vector<Visit> visits = visits_to(samples, {5, 0.75});
  ASSERT_EQ(visits.size(), 1U);
  // A disc of 1.25 holds what is within 1 along the stroke.
  EXPECT_EQ(samples.t(visits[0].begin), 4);
  EXPECT_EQ(samples.t(visits[0].begin + visits[0].length - 1), 6);
  EXPECT_TRUE(visits[0].ends);
  EXPECT_EQ(visits[0].decided_by, no_index);
}

TEST(Visits, AreOneForEachLegOfAHairpinAllInReach) {
  const StrokeSamples samples = samples_of(hairpin(0.6));
  const std::vector<Visit> visits = visits_to(samples, {3.6, 0.2});
  ASSERT_EQ(visits.size(), 2U);
  EXPECT_EQ(visits[1].begin, visits[0].begin + visits[0].length);
  // They part where the stroke is farthest away, in the bend.
  const double apart_at = samples.t(visits[1].begin);
  EXPECT_NEAR(apart_at, 4 + 0.3 * std::numbers::pi / 2, 0.25);
  EXPECT_GE(visits[0].decided_by, visits[1].begin);
}

TEST(Visits, AreOneBeyondTheCentreOfABend) {
  const StrokeSamples samples = samples_of(hairpin(0.6));
  EXPECT_EQ(visits_to(samples, {4.1, 0.3}).size(), 1U);
  EXPECT_EQ(visits_to(samples, {4.8, 0.3}).size(), 1U);
}

TEST(Visits, DoNotHeedATremble) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> tremble(-0.004, 0.004);
  std::vector<Vec2d> places;
  for (int i = 0; i <= 400; ++i) places.emplace_back(0.01 * i, tremble(random));
  EXPECT_EQ(visits_to(samples_of(places), {2, 0.5}).size(), 1U);
}

TEST(Visits, AreThoseOfEachRoundOfAClosedStroke) {
  std::vector<Vec2d> circle;
  for (int i = 0; i < 100; ++i)
    circle.emplace_back(0.5 * std::cos(0.02 * std::numbers::pi * i),
                        0.5 * std::sin(0.02 * std::numbers::pi * i));
  const StrokeSamples samples = samples_of(circle, true);
  for (const Vec2d& x : {Vec2d(0.3, 0.1), Vec2d(-0.2, 0.2), Vec2d(0, -0.4)}) {
    const Visits visits(samples, Vec3f(static_cast<float>(x.x()), static_cast<float>(x.y()), 0),
                        Vec3f::UnitZ());
    const Visits::Found first = visits.find(0, 0);
    EXPECT_EQ(first.visit.length, samples.size());
    for (Index sample = 1; sample < samples.size(); ++sample)
      EXPECT_EQ(visits.find(sample, 0).visit.begin, first.visit.begin);
  }
}

/// How many visits were met that were final, and that more samples could have cut.
struct Met {
  std::size_t cut = 0, open = 0;
};

/// Lets a stroke grow from `least` places on. Expects that samples that stay are of the visits to x that they
/// were of, unless what told it has changed; looks at the visit of the sample `first`.
Met expect_to_stay(const std::vector<Vec2d>& places, std::size_t least, const Vec3f& x, Index first) {
  Met met;
  for (std::size_t count = least; count + 1 < places.size(); ++count) {
    const StrokeSamples before =
        samples_of({places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count)});
    const StrokeSamples after =
        samples_of({places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count) + 1});
    const Index stay = before.size() - 1;
    const Visit was = Visits(before, x, Vec3f::UnitZ()).find(first, 0).visit;
    const Visit is = Visits(after, x, Vec3f::UnitZ()).find(first, 0).visit;
    EXPECT_EQ(is.begin, was.begin);
    met.open += was.decided_by == before.size() ? 1 : 0;
    met.cut += was.ends ? 1 : 0;
    if (was.decided_by == no_index || was.decided_by < stay) {
      EXPECT_EQ(std::min(is.begin + is.length, stay), std::min(was.begin + was.length, stay)) << count;
    }
  }
  return met;
}

TEST(Visits, StayWhateverComesAfterWhatTold) {
  const Met met = expect_to_stay(hairpin(0.6), 60, {3.6F, 0.2F, 0}, 24);
  EXPECT_GT(met.open, 0U);
  EXPECT_GT(met.cut, 20U);
}

// A visit that has all samples so far may still be cut by the next one.
TEST(Visits, StayWhereAllOfTheStrokeIsInReach) {
  std::vector<Vec2d> circle;
  for (int i = 0; i < 40; ++i)
    circle.emplace_back(0.4 * std::cos(0.05 * std::numbers::pi * i),
                        0.4 * std::sin(0.05 * std::numbers::pi * i));
  const Met met = expect_to_stay(circle, 4, {0.3F, 0.1F, 0}, 0);
  EXPECT_GT(met.open, 0U);
  EXPECT_GT(met.cut, 5U);
}

// Visits are separated only at samples where the stroke may turn.
TEST(StrokeSamples, MayTurnWhereverVisitsPart) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> bend(-0.25, 0.6), place(-1.5, 1.5);
  std::size_t parted = 0, straight = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec2d> places{{0, 0}};
    double angle = 0;
    for (int i = 0; i < 60; ++i) {
      angle += bend(random);
      places.emplace_back(places.back() + 0.1 * Vec2d(std::cos(angle), std::sin(angle)));
    }
    const StrokeSamples samples = samples_of(places);
    for (Index i = 0; i < samples.size(); ++i) straight += samples.may_turn(i) ? 0 : 1;
    for (int i = 0; i < 20; ++i) {
      const std::vector<Visit> visits = visits_to(samples, {place(random), place(random)});
      for (std::size_t v = 1; v < visits.size(); ++v) {
        if (visits[v].begin != visits[v - 1].begin + visits[v - 1].length) continue;
        EXPECT_TRUE(samples.may_turn(visits[v].begin - 1));
        ++parted;
      }
    }
  }
  EXPECT_GT(parted, 50U);
  EXPECT_GT(straight, 1000U);
}

}  // namespace
}  // namespace burin
