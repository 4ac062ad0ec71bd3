#include <burin/stroke/curve/geodesic_curvature.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

/// A circle of latitude drawn eastwards for `angle` radians.
std::vector<Vec3d> parallel_circle(int samples, double latitude, double angle) {
  std::vector<Vec3d> places;
  for (int i = 0; i < samples; ++i) {
    const double a = angle * i / (samples - 1);
    places.emplace_back(std::cos(latitude) * std::cos(a), std::cos(latitude) * std::sin(a),
                        std::sin(latitude));
  }
  return places;
}

std::vector<float> curvature_of(const SurfaceCurve& curve, double window) {
  GeodesicCurvature curvature;
  curvature.update(curve, window);
  return curvature.values();
}

TEST(GeodesicCurvature, IsThatOfACircleOfLatitude) {
  const Surface surface = make_surface(test::sphere(6, 0.15, 4));
  const Picker picker(surface);
  const double latitude = 0.5;
  const SurfaceCurve curve = test::traced(surface, picker, 0.2, parallel_circle(60, latitude, 1.5));
  for (const float k : curvature_of(curve, 0.1)) EXPECT_NEAR(k, std::tan(latitude), 0.02);
}

TEST(GeodesicCurvature, IsZeroAlongAGreatCircle) {
  const Surface surface = make_surface(test::sphere(6, 0.15, 4));
  const Picker picker(surface);
  const SurfaceCurve curve = test::traced(surface, picker, 0.2, parallel_circle(60, 0, 2));
  for (const float k : curvature_of(curve, 0.1)) EXPECT_NEAR(k, 0, 0.01);
}

TEST(GeodesicCurvature, StandsTheNoiseOfDenseSamples) {
  const Surface surface = make_surface(test::plane(1, 0.01, 2));
  const Picker picker(surface);
  std::mt19937 random(5);
  std::vector<Vec3d> samples;
  for (int i = 0; i < 150; ++i) {
    const double angle = 2. * i / 149, noise = 1e-4 * (static_cast<double>(random() % 2001) - 1000) / 1000;
    samples.emplace_back((0.7 + noise) * std::cos(angle), (0.7 + noise) * std::sin(angle), 0);
  }
  const SurfaceCurve curve = test::traced(surface, picker, 0.5, samples);
  const std::vector<float> curvature = curvature_of(curve, 0.2);
  for (std::size_t i = 0; i < curvature.size(); ++i) {
    if (curve.points[i].t < 0.1 || curve.points[i].t > curve.length() - 0.1) continue;
    EXPECT_NEAR(curvature[i], 1 / 0.7, 0.15);
  }
}

TEST(GeodesicCurvature, FollowsAGrowingCurveBitForBit) {
  const Surface surface = make_surface(test::sphere(5, 0.15, 4));
  const Picker picker(surface);
  const std::vector<Vec3d> samples = parallel_circle(60, 0.7, 3);
  GeodesicCurvature growing;
  std::size_t before = 0;
  for (std::size_t n = 1; n <= samples.size(); ++n) {
    CurveTracer tracer(surface, picker, 0.2);
    for (std::size_t i = 0; i < n; ++i) tracer.add(*picker.closest(samples[i].cast<float>(), 0.1F), 0, {});
    growing.update(tracer.curve(), 0.1, before);
    ASSERT_EQ(growing.values(), curvature_of(tracer.curve(), 0.1)) << n;
    before = tracer.final_points();
  }
  EXPECT_GT(before, 50U);
}

TEST(GeodesicCurvature, OfStraightLegsEndsAtTheirCorner) {
  const Surface surface = make_surface(test::plane(1, 0.05, 2));
  const Picker picker(surface);
  SurfaceCurve curve = test::traced(surface, picker, 0.2, {{-0.5, 0, 0}, {0, 0, 0}});
  SurfaceCurve other = test::traced(surface, picker, 0.2, {{0, 0, 0}, {0, 0.5, 0}});
  const double corner = curve.length();
  for (CurvePoint& point : other.points) {
    point.t += corner;
    curve.points.push_back(point);
  }
  for (const float k : curvature_of(curve, 0.1)) EXPECT_NEAR(k, 0, 1e-4);
}

TEST(GeodesicCurvature, IsTheSameHoweverDenseThePointsLie) {
  SurfaceCurve curve;
  constexpr double radius = 0.5;
  constexpr int count = 3000;
  for (int i = 0; i < count; ++i) {
    const double t = 1.5 * i / count, angle = t / radius;
    CurvePoint point{};
    point.normal = Vec3f::UnitZ();
    point.tangent = Vec3d(-std::sin(angle), std::cos(angle), 0).cast<float>();
    point.at.position = (radius * Vec3d(std::cos(angle), std::sin(angle), 0)).cast<float>();
    point.t = t;
    curve.points.push_back(point);
  }
  for (const float k : curvature_of(curve, 0.25)) EXPECT_NEAR(k, 1 / radius, 0.01);
}

TEST(GeodesicCurvature, OfAPointIsZero) {
  const Surface surface = make_surface(test::plane(1, 0.1, 2));
  const Picker picker(surface);
  EXPECT_EQ(curvature_of(test::traced(surface, picker, 0.1, {{0, 0, 0}}), 0.1), std::vector<float>{0});
}

}  // namespace
}  // namespace burin
