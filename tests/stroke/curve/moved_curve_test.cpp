#include <burin/stroke/curve/moved_curve.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

using std::numbers::pi;
constexpr double radius = 0.2;

struct Plane {
  Surface surface;
  Picker picker;
  explicit Plane(const TriangleMesh& mesh) : surface(make_surface(mesh)), picker(surface) {}

  CurveTracer trace(const std::vector<Vec3d>& places) const {
    CurveTracer tracer(surface, picker, radius);
    double time = 0;
    for (const Vec3d& place : places) tracer.add(*picker.closest(place.cast<float>(), 1), time += 0.01, {});
    return tracer;
  }
};

const Plane& flat() {
  static const Plane ground(test::plane(1, 0.02, 1));
  return ground;
}

std::vector<Vec3d> line(const Vec3d& from, const Vec3d& to) {
  return test::sampled(30, [&](double s) -> Vec3d { return from + s * (to - from); });
}

/// Offsets that are a function of t.
template <class OffsetAt>
MovedCurve::Offsets by_t(const OffsetAt& offset_at) {
  return [=](const SurfaceCurve& drawn, std::size_t first) {
    std::vector<CurveOffset> offsets;
    for (std::size_t i = first; i < drawn.points.size(); ++i) offsets.push_back(offset_at(drawn.points[i].t));
    return offsets;
  };
}

MovedCurve::Offsets across(double amplitude, double wavelength) {
  return by_t([=](double t) {
    return CurveOffset{0, static_cast<float>(amplitude * std::sin(2 * pi * t / wavelength))};
  });
}

SurfaceCurve moved(const CurveTracer& tracer, const SurfaceCurve& drawn, const MovedCurve::Offsets& offsets) {
  MovedCurve curve(tracer, radius, {}, {});
  curve.follow(drawn, tracer.final_points(), offsets);
  return curve.curve();
}

SurfaceCurve moved(const CurveTracer& tracer, const MovedCurve::Offsets& offsets) {
  return moved(tracer, tracer.curve(), offsets);
}

TEST(MovedCurve, IsASineOverAStraightLine) {
  const CurveTracer tracer = flat().trace(line({-0.7, 0.1, 0}, {0.7, 0.1, 0}));
  const double amplitude = 0.1, k = 2 * pi / 0.5;
  const SurfaceCurve curve = moved(tracer, across(amplitude, 0.5));
  double expected_t = 0, x_before = -0.7, worst_place = 0, worst_t = 0, worst_angle = 0;
  ASSERT_GT(curve.points.size(), 150U);
  for (const CurvePoint& point : curve.points) {
    const double x = point.at.position.x(), slope = amplitude * k * std::cos(k * (x + 0.7));
    worst_place =
        std::max(worst_place, std::abs(point.at.position.y() - 0.1 - amplitude * std::sin(k * (x + 0.7))));
    for (int step = 0; step < 100; ++step) {
      const double between = x_before + (step + 0.5) / 100 * (x - x_before);
      const double there = amplitude * k * std::cos(k * (between + 0.7));
      expected_t += (x - x_before) / 100 * std::sqrt(1 + there * there);
    }
    x_before = x;
    worst_t = std::max(worst_t, std::abs(point.t - expected_t));
    worst_angle =
        std::max(worst_angle, std::abs(std::atan2(point.tangent.y(), point.tangent.x()) - std::atan(slope)));
  }
  std::cout << "places are off by " << worst_place << ", t by " << worst_t << ", angles by " << worst_angle
            << '\n';
  EXPECT_LT(worst_angle, 0.015);
  EXPECT_LT(worst_place, 6e-5);
  EXPECT_LT(worst_t, 6e-5);
  EXPECT_NEAR(curve.points.back().at.position.x(), 0.7, 1e-5) << "the end stays";
}

TEST(MovedCurve, HasPointsAsFarApartAsTheDrawnCurve) {
  const CurveTracer tracer = flat().trace(line({-0.7, 0, 0}, {0.7, 0, 0}));
  const SurfaceCurve curve = moved(tracer, by_t([](double t) {
                                     return CurveOffset{static_cast<float>(0.2 * std::sin(8 * t)), 0};
                                   }));
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const double step = curve.points[i].t - curve.points[i - 1].t;
    EXPECT_GT(step, 1e-6) << i;
    EXPECT_LT(step, 2 * tracer.spacing(curve.points[i].at)) << i;
  }
}

TEST(MovedCurve, KeepsTheHandsTimeAndSpeed) {
  const CurveTracer tracer = flat().trace(line({-0.7, 0, 0}, {0.7, 0, 0}));
  const SurfaceCurve curve = moved(tracer, across(0.15, 0.5));
  for (const CurvePoint& point : curve.points) {
    const PenAt hand = pen_at(tracer.curve(), point.at.position.x() + 0.7);
    EXPECT_NEAR(point.time, hand.time, 1e-3);
    EXPECT_NEAR(point.speed, hand.speed, 0.05 * hand.speed + 1e-3);
  }
}

/// An offset that changes with any point of the drawn curve within the reach, and with none beyond it.
MovedCurve::Offsets mean_of(const CurveReach& reach) {
  return [reach](const SurfaceCurve& drawn, std::size_t first) {
    std::vector<CurveOffset> offsets;
    for (std::size_t i = first; i < drawn.points.size(); ++i) {
      const double t = drawn.points[i].t;
      double sum = 0, count = 0;
      for (const CurvePoint& point : drawn.points) {
        if (point.t < t - reach.behind || point.t > t + reach.ahead) continue;
        sum += static_cast<double>(point.tangent.y()) + std::sin(20 * point.t);
        ++count;
      }
      offsets.push_back({static_cast<float>(0.02 * sum / count), static_cast<float>(0.1 * sum / count)});
    }
    return offsets;
  };
}

bool same(const CurvePoint& a, const CurvePoint& b) {
  return a.at.position == b.at.position && a.normal == b.normal && a.tangent == b.tangent && a.t == b.t &&
         a.time == b.time && a.speed == b.speed && a.width == b.width;
}

TEST(MovedCurve, IsTheSameHoweverItWasDrawn) {
  const std::vector<Vec3d> samples =
      test::sampled(60, [](double s) { return Vec3d(1.4 * s - 0.7, 0.4 * std::sin(5 * s), 0); });
  for (const CurveReach& reach : {CurveReach{0, 0}, CurveReach{0.1, 0.15}, CurveReach{0.05, 0}}) {
    CurveTracer tracer(flat().surface, flat().picker, radius);
    MovedCurve often(tracer, radius, {}, reach), seldom(tracer, radius, {}, reach);
    std::vector<CurvePoint> seen;
    std::size_t final_before = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      tracer.add(*flat().picker.closest(samples[i].cast<float>(), 1), 0.01 * static_cast<double>(i), {});
      often.follow(tracer.curve(), tracer.final_points(), mean_of(reach));
      if (i % 7 == 3) seldom.follow(tracer.curve(), tracer.final_points(), mean_of(reach));
      const auto& points = often.curve().points;
      ASSERT_GE(points.size(), final_before);
      for (std::size_t p = 0; p < final_before; ++p) ASSERT_TRUE(same(points[p], seen[p])) << i << ' ' << p;
      seen = points;
      ASSERT_GE(often.final_points(), final_before);
      final_before = often.final_points();
    }
    const std::size_t known = tracer.final_points();
    EXPECT_GT(often.curve().points[often.final_points() - 1].time,
              pen_at(tracer.curve(), tracer.curve().points[known - 1].t - reach.ahead - 0.06).time)
        << "only the last part is not final";
    MovedCurve at_once(tracer, radius, {}, reach);
    at_once.follow(tracer.curve(), known, mean_of(reach));
    seldom.follow(tracer.curve(), known, mean_of(reach));
    const auto expected = at_once.curve().points;
    EXPECT_TRUE(std::ranges::equal(often.curve().points, expected, same));
    EXPECT_TRUE(std::ranges::equal(seldom.curve().points, expected, same));
  }
}

TEST(MovedCurve, MovesAlongGeodesicsOfASphere) {
  const Plane ball(test::sphere(6, 0.2, 3));
  const CurveTracer tracer =
      ball.trace(test::sampled(40, [](double s) { return Vec3d(std::cos(1.5 * s), std::sin(1.5 * s), 0); }));
  const SurfaceCurve curve = moved(tracer, by_t([](double) { return CurveOffset{0, 0.7F}; }));
  for (const CurvePoint& point : curve.points)
    EXPECT_NEAR(std::asin(point.at.position.z() / point.at.position.norm()), 0.7, 1e-3);
  EXPECT_NEAR(curve.length(), 1.5 * std::cos(0.7), 2e-3);
}

TEST(MovedCurve, StopsWhereTheSurfaceEnds) {
  const CurveTracer tracer = flat().trace(line({-0.7, 0.8, 0}, {0.7, 0.9, 0}));
  const SurfaceCurve curve = moved(tracer, across(0.3, 0.7));
  double highest = 0;
  std::size_t at_rim = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const Vec3f &place = curve.points[i].at.position, &before = curve.points[i - 1].at.position;
    highest = std::max(highest, static_cast<double>(place.y()));
    at_rim += place.y() > 0.99F;
    EXPECT_GT(place.x(), before.x() - 1e-4F) << "no point goes along the rim";
  }
  EXPECT_LE(highest, 1 + 1e-6);
  EXPECT_GT(at_rim, 20U);
}

TEST(MovedCurve, TurnsOverAnEdge) {
  const Plane step(
      test::patch({.u_min = -0.5,
                   .u_max = 0.5,
                   .v_min = -0.5,
                   .v_max = 0.5,
                   .cells_u = 50,
                   .cells_v = 50,
                   .jitter_u = 0,
                   .jitter_v = 0},
                  [](double u, double v) { return Vec3d(u, std::min(v, 0.), -std::max(v, 0.)); }));
  const CurveTracer tracer = step.trace(line({-0.3, -0.11, 0}, {0.3, -0.11, 0}));
  const SurfaceCurve curve = moved(tracer, by_t([](double) { return CurveOffset{0, 0.3F}; }));
  for (const CurvePoint& point : curve.points) {
    EXPECT_NEAR(point.at.position.y(), 0, 1e-5);
    EXPECT_NEAR(point.at.position.z(), -0.19, 1e-2) << "a step cuts the corner";
  }
}

TEST(MovedCurve, GoesAroundAClosedStrokeWithoutASeam) {
  const CurveTracer tracer = flat().trace(test::sampled(
      60, [](double s) { return Vec3d(0.5 * std::cos(2 * pi * s), 0.5 * std::sin(2 * pi * s), 0); }));
  const std::optional<SurfaceCurve> drawn = tracer.closed_curve(Closure::closed);
  ASSERT_TRUE(drawn);
  const double length = drawn->length();
  const SurfaceCurve curve = moved(tracer, *drawn, across(0.08, length / 5));
  ASSERT_TRUE(curve.closed);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const CurvePoint &from = curve.points[i], &to = curve.points[curve.next(i)];
    const double step = curve.segment_end(i) - from.t, chord = (to.at.position - from.at.position).norm();
    ASSERT_GT(step, 0) << i;
    ASSERT_NEAR(step, chord, 0.01 * chord + 1e-6) << i;
    ASSERT_LT((to.tangent - from.tangent).norm(), 0.25) << i;
    const double angle = std::atan2(from.at.position.y(), from.at.position.x());
    EXPECT_NEAR(from.at.position.norm(), 0.5 - 0.08 * std::sin(5 * angle), 2e-3) << i;
  }
}

TEST(MovedCurve, IsOnePointOfATap) {
  const CurveTracer tracer = flat().trace({{0.2, 0.1, 0}});
  const SurfaceCurve curve = moved(tracer, by_t([](double) { return CurveOffset{0.1F, 0}; }));
  ASSERT_EQ(curve.points.size(), 1U);
  EXPECT_NEAR((curve.points[0].at.position - tracer.curve().points[0].at.position).norm(), 0.1, 1e-5);
}

}  // namespace
}  // namespace burin
