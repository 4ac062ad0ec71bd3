#include <burin/feature/snap.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "feature/known_lines.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

constexpr double half = 20, height = 8;

double rim_of(double x, double y) { return std::max(std::abs(x), std::abs(y)); }

/// A square plateau, |x|, |y| <= half at z = height, with slopes of 58 degrees around it that are cones at
/// its corners.
Vec3d on_plateau(double x, double y) {
  const double off = std::hypot(std::max(std::abs(x) - half, 0.), std::max(std::abs(y) - half, 0.));
  return {x, y, height - 1.6 * off};
}

/// Its mesh has vertices on the plateau's rim; the others are moved at random.
TriangleMesh plateau() {
  std::mt19937 random(3);
  const auto moved = [&] { return 0.6 * (static_cast<double>(random()) / 4294967296. - 0.5); };
  return shuffled(patch({-30, 30, -30, 30, 60, 60, false, 0, 0, 3},
                        [&](double x, double y) {
                          if (std::abs(rim_of(x, y) - half) > 0.5) x += moved(), y += moved();
                          return on_plateau(x, y);
                        }),
                  4);
}

/// A pen that goes around the plateau, within it or beside it, by round corners.
std::vector<Vec3d> rounded(double inset, double corner, double from, double to) {
  std::vector<Vec3d> pen;
  const double reach = half - inset, straight = reach - corner;
  for (int i = 0; i <= 200; ++i) {
    const double angle = from + (to - from) * i / 200, c = std::cos(angle), s = std::sin(angle);
    // The point of a rounded square in this direction, by a search outwards.
    double low = 0, high = 2 * reach;
    for (int k = 0; k < 40; ++k) {
      const double r = (low + high) / 2, x = std::abs(r * c) - straight, y = std::abs(r * s) - straight;
      const double distance =
          std::hypot(std::max(x, 0.), std::max(y, 0.)) + std::min(std::max(x, y), 0.) - corner;
      (distance < 0 ? low : high) = r;
    }
    pen.push_back(on_plateau(low * c, low * s));
  }
  return pen;
}

double nearest(const SurfaceCurve& curve, const Vec3d& place) {
  double least = 1e9;
  for (const CurvePoint& point : curve.points)
    least = std::min(least, (point.at.position.cast<double>() - place).norm());
  return least;
}

double farthest_from_rim(const SurfaceCurve& curve) {
  double most = 0;
  for (const CurvePoint& point : curve.points)
    most = std::max({most, std::abs(rim_of(point.at.position.x(), point.at.position.y()) - half),
                     std::abs(point.at.position.z() - height)});
  return most;
}

TEST(Crease, KeepsTheCornersThatStrokesRoundOff) {
  SnapScene scene(plateau());
  for (const double inset : {2., -1., 4.}) {
    const SnapResult result = scene.snap(rounded(inset, 6, 0.2, 1.4), {FeatureKind::crease}, {.radius = 10});
    EXPECT_NEAR(result.snapped_share, 1, 1e-6) << inset;
    EXPECT_LT(farthest_from_rim(result.curve), 1e-4) << inset;
    EXPECT_LT(nearest(result.curve, {half, half, height}), 1e-4) << "the corner, inset " << inset;
    EXPECT_NEAR(result.curve.length(), 2 * half - half * (std::tan(0.2) + 1 / std::tan(1.4)), 3);
  }
}

TEST(Crease, GoesAroundAllCornersOfAClosedStroke) {
  SnapScene scene(plateau());
  const SnapResult result = scene.snap_closed(rounded(2, 6, 0.1, 0.1 + 2 * 3.14159265358979),
                                              {FeatureKind::crease}, {.radius = 10});
  EXPECT_TRUE(result.curve.closed);
  EXPECT_LT(farthest_from_rim(result.curve), 1e-4);
  for (const double x : {-half, half})
    for (const double y : {-half, half}) EXPECT_LT(nearest(result.curve, {x, y, height}), 1e-4);
  EXPECT_NEAR(result.curve.length(), 8 * half, 0.01);
}

TEST(Crease, IsAnEdgeOfTheLeastAngle) {
  SnapScene scene(plateau());
  const auto pen = rounded(2, 6, 0.2, 1.4);
  EXPECT_FALSE(
      scene.snap(pen, {.kind = FeatureKind::crease, .least_angle = 57}, {.radius = 10}).ranges.empty());
  EXPECT_TRUE(
      scene.snap(pen, {.kind = FeatureKind::crease, .least_angle = 80}, {.radius = 10}).ranges.empty());
}

}  // namespace
}  // namespace burin::test
