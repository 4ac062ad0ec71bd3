#include <burin/feature/snap.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "feature/known_lines.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// A vase about the z axis whose radius waves along it; its edges are about 1 long.
struct Vase {
  static constexpr double mean = 30, wave = 3, length = 30 / (2 * std::numbers::pi);

  static double radius(double z) { return mean + wave * std::cos(z / length); }
  static double slope(double z) { return -wave / length * std::sin(z / length); }
  static Vec3d at(double angle, double z) {
    return {radius(z) * std::cos(angle), radius(z) * std::sin(angle), z};
  }

  /// The sign of the radial curvature, for a unit vector to the viewer: that of the sum of principal
  /// curvatures times the squares of the vector's components along their directions.
  static double radial(double angle, double z, const Vec3d& to_viewer) {
    const double steep = slope(z), along = std::sqrt(1 + steep * steep);
    const Vec3d meridian = Vec3d(steep * std::cos(angle), steep * std::sin(angle), 1) / along;
    const Vec3d parallel(-std::sin(angle), std::cos(angle), 0);
    const double bend = wave / (length * length) * std::cos(z / length) / (along * along * along);
    const double m = to_viewer.dot(meridian), p = to_viewer.dot(parallel);
    return bend * m * m + p * p / (radius(z) * along);
  }

  /// Where the radial curvature rises through 0 with z, near the inflection of the meridian.
  static double suggestive(double angle, const std::function<Vec3d(const Vec3d&)>& to_viewer) {
    double low = -13, high = -5;
    for (int i = 0; i < 60; ++i) {
      const double z = (low + high) / 2;
      (radial(angle, z, to_viewer(at(angle, z))) < 0 ? low : high) = z;
    }
    return low;
  }

  static TriangleMesh mesh() {
    return shuffled(patch({-1.1, 1.1, -22, 10, 75, 38, false, 0.3, 0.3, 3}, at), 4);
  }
};

void expect_contour(const Viewpoint& view, double noise, double scale) {
  const auto to_viewer = [&](const Vec3d& x) {
    return Vec3d((view.is_eye ? Vec3d(view.at - x) : Vec3d(-view.at)).normalized());
  };
  TriangleMesh mesh = Vase::mesh();
  if (noise > 0) add_noise(mesh, noise, 8);
  SnapScene scene(mesh);
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) {
    const double angle = -0.8 + 1.6 * i / 60;
    pen.push_back(Vase::at(angle, Vase::suggestive(angle, to_viewer) + 2 + 1.5 * std::sin(i / 6.)));
  }
  const SnapResult result = scene.snap(pen, {FeatureKind::suggestive, view}, {.radius = 10, .scale = scale});
  const auto errors = distances(result, [&](const Vec3d& x) {
    const double angle = std::atan2(x.y(), x.x());
    double least = 1e9;
    for (int i = -100; i <= 100; ++i) {
      const double beside = angle + i * 1e-3;
      least = std::min(least, (Vase::at(beside, Vase::suggestive(beside, to_viewer)) - x).norm());
    }
    return least;
  });
  std::cout << "share " << result.snapped_share << ", median " << quantile(errors, 0.5) << ", p95 "
            << quantile(errors, 0.95) << " edges\n";
  EXPECT_GT(result.snapped_share, 0.95);
  EXPECT_LT(quantile(errors, 0.5), noise > 0 ? 0.25 : 0.1);
  EXPECT_LT(quantile(errors, 0.95), noise > 0 ? 1 : 0.5);
}

TEST(Suggestive, ContoursAreFoundFromAfar) {
  expect_contour({false, -Vec3d(std::cos(0.87), 0.1, std::sin(0.87))}, 0, 0);
}

TEST(Suggestive, ContoursAreFoundFromNearby) { expect_contour({true, Vec3d(70, 5, 60)}, 0, 0); }

TEST(Suggestive, ContoursAreFoundInNoise) {
  expect_contour({false, -Vec3d(std::cos(0.87), 0.1, std::sin(0.87))}, 0.05, 3);
}

}  // namespace
}  // namespace burin::test
