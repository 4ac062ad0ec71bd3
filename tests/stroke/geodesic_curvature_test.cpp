#include <burin/stroke/geodesic_curvature.h>
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

TEST(GeodesicCurvature, IsThatOfACircleOfLatitude) {
  const Surface surface = make_surface(test::sphere(6, 0.15, 4));
  const Picker picker(surface);
  const double latitude = 0.5;
  const SurfaceCurve curve = test::traced(surface, picker, 0.2, parallel_circle(60, latitude, 1.5));
  for (const float k : geodesic_curvature(curve, 0.1)) EXPECT_NEAR(k, std::tan(latitude), 0.02);
}

TEST(GeodesicCurvature, IsZeroAlongAGreatCircle) {
  const Surface surface = make_surface(test::sphere(6, 0.15, 4));
  const Picker picker(surface);
  const SurfaceCurve curve = test::traced(surface, picker, 0.2, parallel_circle(60, 0, 2));
  for (const float k : geodesic_curvature(curve, 0.1)) EXPECT_NEAR(k, 0, 0.01);
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
  const std::vector<float> curvature = geodesic_curvature(curve, 0.2);
  for (std::size_t i = 0; i < curvature.size(); ++i) {
    if (curve.points[i].t < 0.1 || curve.points[i].t > curve.length() - 0.1) continue;
    EXPECT_NEAR(curvature[i], 1 / 0.7, 0.15);
  }
}

TEST(GeodesicCurvature, OfAPointIsZero) {
  const Surface surface = make_surface(test::plane(1, 0.1, 2));
  const Picker picker(surface);
  EXPECT_EQ(geodesic_curvature(test::traced(surface, picker, 0.1, {{0, 0, 0}}), 0.1), std::vector<float>{0});
}

}  // namespace
}  // namespace burin
