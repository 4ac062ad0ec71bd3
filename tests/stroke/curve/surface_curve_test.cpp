#include <burin/stroke/curve/surface_curve.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

struct TracedGround {
  Surface surface;
  Picker picker;
  explicit TracedGround(const TriangleMesh& mesh) : surface(make_surface(mesh)), picker(surface) {}
};

std::vector<Vec3d> circle(int samples, double radius, double z) {
  std::vector<Vec3d> places;
  for (int i = 0; i < samples; ++i) {
    const double angle = 1.5 * i / (samples - 1);
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return places;
}

TEST(CurveTracer, FollowsAnArcBetweenSparseSamples) {
  TracedGround ground(test::plane(1, 0.02, 1));
  const SurfaceCurve curve = test::traced(ground.surface, ground.picker, 0.1, circle(16, 0.7, 0));
  EXPECT_NEAR(curve.length(), 1.5 * 0.7, 1e-3);
  for (const CurvePoint& point : curve.points) {
    if (point.t < 0.1 || point.t > curve.length() - 0.1) continue;  // the ends have one-sided tangents
    const Vec3f radial = point.at.position.normalized();
    EXPECT_NEAR(point.at.position.norm(), 0.7F, 1e-4F);
    EXPECT_NEAR(point.tangent.dot(radial), 0, 5e-3F);
    EXPECT_NEAR(point.tangent.norm(), 1, 1e-5F);
  }
}

TEST(CurveTracer, LeavesPointsHalfAnEdgeApart) {
  TracedGround ground(test::plane(1, 0.02, 1));
  const SurfaceCurve curve = test::traced(ground.surface, ground.picker, 0.2, {{-0.5, 0, 0}, {0.5, 0, 0}});
  EXPECT_NEAR(static_cast<double>(curve.points.size()), 1 / 0.011, 10);
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    EXPECT_GT(curve.points[i].t, curve.points[i - 1].t);
    EXPECT_LT(curve.points[i].t - curve.points[i - 1].t, 0.025);
  }
}

TEST(CurveTracer, LiesOnTheSurfaceWithTangentFrames) {
  TracedGround ground(test::sphere(5, 0.2, 3));
  const SurfaceCurve curve = test::traced(ground.surface, ground.picker, 0.2, circle(12, 0.9, 0.435));
  ASSERT_GT(curve.points.size(), 50U);
  for (const CurvePoint& point : curve.points) {
    const auto closest = ground.picker.closest(point.at.position, 0.1F);
    ASSERT_TRUE(closest.has_value());
    EXPECT_LT((closest->position - point.at.position).norm(), 1e-6F);
    EXPECT_NEAR(point.normal.norm(), 1, 1e-5F);
    EXPECT_NEAR(point.tangent.dot(point.normal), 0, 1e-5F);
  }
}

TEST(CurveTracer, LeavesTheFinalPartAloneWhenSamplesArrive) {
  TracedGround ground(test::sphere(4, 0.2, 3));
  CurveTracer tracer(ground.surface, ground.picker, 0.2);
  std::vector<CurvePoint> final_part;
  for (const Vec3d& sample : circle(20, 0.8, 0.6)) {
    tracer.add(*ground.picker.closest(sample.cast<float>(), 1), 0, {});
    const auto& points = tracer.curve().points;
    for (std::size_t i = 0; i < final_part.size(); ++i) {
      EXPECT_EQ(points[i].at.position, final_part[i].at.position);
      EXPECT_EQ(points[i].tangent, final_part[i].tangent);
      EXPECT_EQ(points[i].t, final_part[i].t);
    }
    final_part.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(tracer.final_points()));
  }
  EXPECT_GT(final_part.size(), 20U);
  EXPECT_LT(final_part.size(), tracer.curve().points.size());
}

TEST(CurveTracer, TakesRepeatedSamplesAsOne) {
  TracedGround ground(test::plane(1, 0.1, 1));
  const std::vector<Vec3d> once = {{-0.5, 0, 0}, {0, 0.2, 0}, {0.5, 0, 0}};
  const std::vector<Vec3d> often = {{-0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.2, 0},
                                    {0, 0.2, 0},  {0, 0.2, 0},  {0.5, 0, 0}};
  const auto a = test::traced(ground.surface, ground.picker, 0.1, once);
  const auto b = test::traced(ground.surface, ground.picker, 0.1, often);
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.length(), b.length());
}

TEST(CurveTracer, ConnectsAlongTheSurfaceButNotAcrossAGap) {
  TriangleMesh two = test::plane(1, 0.1, 1);
  const auto count = static_cast<Index>(two.positions.size());
  TriangleMesh lower = two;
  for (Vec3f& p : lower.positions) two.positions.emplace_back(p - Vec3f(0, 0, 3));
  for (const auto& [a, b, c] : lower.triangles) two.triangles.push_back({a + count, b + count, c + count});
  TracedGround ground(two);
  CurveTracer tracer(ground.surface, ground.picker, 0.1);
  tracer.add(*ground.picker.closest(Vec3f(0, 0, 0), 1), 0, {});
  EXPECT_TRUE(tracer.connects(*ground.picker.closest(Vec3f(0.9F, 0.3F, 0), 1)));
  EXPECT_FALSE(tracer.connects(*ground.picker.closest(Vec3f(0.2F, 0, -3), 1)));
}

TEST(CurveTracer, ConnectsThroughStepsBelowTheRoundingOfPlaces) {
  const TracedGround ground(test::shuffled(test::plane(1, 0.05, 3), 5));
  CurveTracer tracer(ground.surface, ground.picker, 0.2);
  for (int i = 0; i < 5000; ++i) {
    const Vec3f place(0.7F + 1e-7F * static_cast<float>(i), -0.61F, 0);
    const SurfacePoint at = *ground.picker.closest(place, 1);
    ASSERT_TRUE(tracer.connects(at)) << i;
    tracer.add(at, i, {});
  }
  EXPECT_LT(tracer.curve().points.size(), 8u) << "a slow pen leaves no more points than a fast one";
}

TEST(CurveTracer, SaysWhatASampleChanged) {
  const TracedGround ground(test::plane(1, 0.05, 3));
  CurveTracer tracer(ground.surface, ground.picker, 0.2);
  const auto add = [&](float x, float pressure) {
    return tracer.add(*ground.picker.closest(Vec3f(x, 0, 0), 1), 0, {.pressure = pressure});
  };
  EXPECT_EQ(add(0, 1), PenPath::Change::path);
  EXPECT_EQ(add(1e-6F, 1), PenPath::Change::none);
  EXPECT_EQ(add(2e-6F, 0.5F), PenPath::Change::pen);
  EXPECT_EQ(tracer.curve().points.back().pen.pressure, 0.5F);
  EXPECT_EQ(add(0.1F, 0.5F), PenPath::Change::path);
}

TEST(CurveTracer, TakesTheWidthFromThePressure) {
  TracedGround ground(test::plane(1, 0.02, 1));
  CurveTracer tracer(ground.surface, ground.picker, 0.1, StrokeWidth(0.8, {}, {{.pressure = true}}));
  const float pressures[] = {1, 0, 0.5F};
  for (const int i : {0, 1, 2}) {
    const Vec3f place(-0.5F + 0.5F * static_cast<float>(i), 0, 0);
    tracer.add(*ground.picker.closest(place, 1), i, {.pressure = pressures[i]});
  }
  for (const CurvePoint& point : tracer.curve().points) {
    EXPECT_NEAR(point.width, 0.2 + 0.8 * point.pen.pressure, 1e-6);
    EXPECT_EQ(pen_at(tracer.curve(), point.t).width, point.width);
  }
  EXPECT_EQ(tracer.curve().points[0].width, 1);
  EXPECT_NEAR(pen_at(tracer.curve(), 0.5).width, 0.2, 1e-3);
  EXPECT_NEAR(pen_at(tracer.curve(), 1).width, 0.6, 1e-6);
}

/// A pen along x from -0.7 on, drawn so many times a second: place, pressure and tilt are smooth in time.
SurfaceCurve smoothly_drawn(const TracedGround& ground, int rate, double seconds) {
  CurveTracer tracer(ground.surface, ground.picker, 0.1);
  for (int i = 0; i <= rate * seconds; ++i) {
    const double time = static_cast<double>(i) / rate, share = time / seconds;
    const Pen pen{.pressure = static_cast<float>(0.5 + 0.4 * std::sin(5 * share)),
                  .tilt_x = static_cast<float>(std::cos(3 * share))};
    const Vec3d place(-0.7 + 1.4 * (0.7 * share + 0.3 * share * share), 0, 0);
    tracer.add(*ground.picker.closest(place.cast<float>(), 1), time, pen);
  }
  return tracer.curve();
}

TEST(CurveTracer, CarriesThePenSmoothlyBetweenSparseSamples) {
  const TracedGround ground(test::plane(1, 0.02, 1));
  const SurfaceCurve curve = smoothly_drawn(ground, 12, 1);
  double squares = 0;
  for (const CurvePoint& point : curve.points) {
    const double share = (std::sqrt(0.49 + 1.2 * point.t / 1.4) - 0.7) / 0.6;
    squares += std::pow(double{point.pen.pressure} - (0.5 + 0.4 * std::sin(5 * share)), 2);
    EXPECT_NEAR(point.time, share, 1e-3) << point.t;
    EXPECT_NEAR(point.pen.tilt_x, std::cos(3 * share), 4e-3) << point.t;
  }
  // Straight lines between the samples would be off by 0.4 * 25 / 144 / sqrt(120) / sqrt(2) = 0.0045.
  EXPECT_LT(std::sqrt(squares / static_cast<double>(curve.points.size())), 2e-3);
}

TEST(CurveTracer, HasTheSameSpeedAtAnyRate) {
  const TracedGround ground(test::plane(1, 0.02, 1));
  const SurfaceCurve slow = smoothly_drawn(ground, 60, 1.5), fast = smoothly_drawn(ground, 240, 1.5);
  for (double t = 0; t < 1.4; t += 0.01) {
    const double speed = pen_at(fast, t).speed;
    EXPECT_NEAR(pen_at(slow, t).speed, speed, 0.003 * 1.4) << t;
    const double time = pen_at(fast, t).time, rising = 1 - std::exp(-time / 0.04);
    // The mean of a speed a + b time lags by the fading time; from rest it rises as the response to a ramp.
    const double a = 1.4 * 0.7 / 1.5, b = 1.4 * 0.6 / 1.5 / 1.5;
    EXPECT_NEAR(speed, a * rising + b * (time - 0.04 * rising), 0.01) << t;
  }
}

TEST(CurveTracer, MakesSenseOfASpeedWithoutTime) {
  const TracedGround ground(test::plane(1, 0.1, 1));
  CurveTracer tracer(ground.surface, ground.picker, 0.1);
  for (const float x : {-0.5F, 0.F, 0.5F}) tracer.add(*ground.picker.closest(Vec3f(x, 0, 0), 1), 3, {});
  EXPECT_TRUE(std::isfinite(pen_at(tracer.curve(), 0.7).speed));
}

TEST(PenAt, InterpolatesPressureTimeAndSpeed) {
  TracedGround ground(test::plane(1, 0.1, 1));
  CurveTracer tracer(ground.surface, ground.picker, 0.1);
  const auto add = [&](float x, double time, float pressure) {
    tracer.add(*ground.picker.closest(Vec3f(x, 0, 0), 1), time, {pressure, 0, 0, 0});
  };
  add(-0.5F, 10, 0);
  add(0, 10.5, 0.5F);
  add(0.5F, 11.5, 1);
  const PenAt middle = pen_at(tracer.curve(), 0.25), late = pen_at(tracer.curve(), 0.75);
  EXPECT_NEAR(middle.pen.pressure, 0.25F, 0.01F);
  // The secants have 1 and 2 s per unit, so the slopes are 0.5, 1.5 and 2.5.
  EXPECT_NEAR(middle.time, 0.25 - 0.0625, 0.01);
  EXPECT_NEAR(late.time, 1 - 0.0625, 0.01);
  EXPECT_NEAR(middle.speed, 1, 0.1);
  EXPECT_NEAR(late.speed, 0.5, 0.05);
  EXPECT_NEAR(late.t, 0.75, 1e-12);
  EXPECT_NEAR(late.tangent.dot(Vec3f::UnitX()), 1, 1e-4F);
  EXPECT_EQ(pen_at(tracer.curve(), -1).pen.pressure, 0);
  EXPECT_EQ(pen_at(tracer.curve(), 9).pen.pressure, 1);
  EXPECT_EQ(pen_at(tracer.curve(), 9).t, tracer.curve().length());
}

TEST(PenAt, TurnsTheBarrelTheShorterWay) {
  TracedGround ground(test::plane(1, 0.3, 1));
  CurveTracer tracer(ground.surface, ground.picker, 0.5);
  constexpr float degree = std::numbers::pi_v<float> / 180;
  const float degrees[] = {330, 350, 10, 30};
  for (const int i : {0, 1, 2, 3}) {
    const Vec3f place(-0.6F + 0.4F * static_cast<float>(i), 0, 0);
    tracer.add(*ground.picker.closest(place, 1), i, {.twist = degrees[i] * degree});
  }
  for (double t = 0; t <= 1.2; t += 0.01) {
    const double turned = 330 + 50 * t, twist = pen_at(tracer.curve(), t).pen.twist / degree;
    EXPECT_NEAR(std::remainder(twist - turned, 360), 0, 0.01) << t;
  }
}

}  // namespace
}  // namespace burin
