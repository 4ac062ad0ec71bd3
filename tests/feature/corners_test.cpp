// Corners of crests against closed forms: Gaussian bumps along lines with a corner, whose crests are these
// lines.
#include <burin/feature/corners.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "feature/known_lines.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A line in the plane z = 0 that comes from the left below, turns to the right at the origin, and goes on to
/// the right below.
struct BentLine {
  double turn;        ///< radians
  double radius = 0;  ///< of an arc in place of the corner
  Vec3d leg(double side) const { return {side * std::cos(turn / 2), -std::sin(turn / 2), 0}; }
  double arc() const { return radius * std::tan(turn / 2); }  ///< where it begins, from the origin

  double distance(double x, double y) const {
    const Vec3d at(x, y, 0);
    double least = 1e9;
    for (const double side : {-1., 1.})
      least = std::min(least, (at - std::max(at.dot(leg(side)), arc()) * leg(side)).norm());
    const Vec3d from_centre = at + Vec3d(0, radius / std::cos(turn / 2), 0);
    if (std::abs(std::atan2(from_centre.x(), from_centre.y())) <= turn / 2)
      least = std::min(least, std::abs(from_centre.norm() - radius));
    return least;
  }

  /// A pen `beside` it, to its right, that rounds it by an arc of this radius.
  std::vector<Vec3d> pen(double rounding, double beside) const {
    const BentLine rounded{turn, rounding};
    std::vector<Vec3d> pen;
    for (int i = -60; i <= 60; ++i) {
      const double angle = i / rounded.arc() * turn / 2;
      Vec3d place = std::abs(i) * leg(i < 0 ? -1 : 1);
      if (std::abs(i) < rounded.arc())
        place = rounding * Vec3d(std::sin(angle), std::cos(angle) - 1 / std::cos(turn / 2), 0);
      pen.push_back(place - Vec3d(0, beside, 0));
    }
    return pen;
  }
};

/// Snaps pens that round a bump of width `w` along a line in several ways, and returns the greatest distances
/// of the results from it within four scales of its corner or arc, ascending, in edges.
std::vector<double> greatest_errors(const BentLine& line, double w, double noise,
                                    FeatureKind kind = FeatureKind::ridge) {
  const auto height = [&](double x, double y) {
    const double d = line.distance(x, y) / w;
    return (kind == FeatureKind::valley ? -0.5 : 0.5) * w * std::exp(-d * d / 2);
  };
  TriangleMesh mesh = shuffled(patch({-80, 80, -80, 40, 184, 138, false, 0.3, 0.3, 3},
                                     [&](double x, double y) { return Vec3d(x, y, height(x, y)); }),
                               4);
  if (noise > 0) add_noise(mesh, noise, 8);
  SnapScene scene(std::move(mesh));
  std::vector<double> greatest;
  for (const double rounding : {7., 10., 13.}) {
    for (const double beside : {0.5, 3.}) {
      std::vector<Vec3d> pen = line.pen(rounding, beside);
      for (Vec3d& place : pen) place.z() = height(place.x(), place.y());
      const SnapResult result = scene.snap(pen, {kind}, {.radius = 3 * w});
      EXPECT_GT(result.snapped_share, 0.95);
      double most = 0;
      for (const CurvePoint& point : result.curve.points) {
        const auto x = static_cast<double>(point.at.position.x()),
                   y = static_cast<double>(point.at.position.y());
        if (std::hypot(x, y) < 4 * result.scale + line.radius) most = std::max(most, line.distance(x, y));
      }
      greatest.push_back(most);
    }
  }
  std::ranges::sort(greatest);
  std::cout << "turn " << line.turn / degree << ", arc " << line.radius << ", width " << w << ", noise "
            << noise << ": greatest distance " << greatest.front() << " to " << greatest.back() << " edges\n";
  return greatest;
}

TEST(Corners, OfRidgesAreKept) {
  EXPECT_LT(greatest_errors({30 * degree}, 5, 0).back(), 0.2);
  EXPECT_LT(greatest_errors({60 * degree}, 5, 0).back(), 0.3);
  EXPECT_LT(greatest_errors({60 * degree}, 8, 0).back(), 0.5);
  EXPECT_LT(greatest_errors({90 * degree}, 5, 0).back(), 1.5);
}

TEST(Corners, OfValleysAndInNoiseAreKept) {
  EXPECT_LT(greatest_errors({60 * degree}, 5, 0, FeatureKind::valley).back(), 0.3);
  EXPECT_LT(greatest_errors({60 * degree}, 7, 0.05).back(), 0.8);
  EXPECT_LT(greatest_errors({90 * degree}, 7, 0.05).back(), 2);
}

TEST(Corners, AreNotMadeOfBends) {
  // The tangents of these arcs meet 1.5 to 6 edges beside them.
  for (const double turn : {60., 90.})
    for (const double radius : {10., 15.})
      EXPECT_LT(greatest_errors({turn * degree, radius}, 5, 0).back(), 0.5);
}

TEST(Corners, OfClosedLinesAreKept) {
  // A square ring, beside which a closed stroke starts near a corner.
  const auto distance = [](double x, double y) {
    const double ax = std::abs(x), ay = std::abs(y), beyond_x = ax - 35, beyond_y = ay - 35;
    const double outside = std::hypot(std::max(beyond_x, 0.), std::max(beyond_y, 0.));
    return outside > 0 ? outside : -std::max(beyond_x, beyond_y);
  };
  SnapScene scene(shuffled(patch({-60, 60, -60, 60, 138, 138, false, 0.3, 0.3, 3},
                                 [&](double x, double y) {
                                   const double d = distance(x, y) / 4;
                                   return Vec3d(x, y, 2 * std::exp(-d * d / 2));
                                 }),
                           4));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 160; ++i) {
    // A square with corners rounded by a radius of 8, which starts 3 after one of them.
    const double side = 48, arc = 8 * std::numbers::pi / 2, at = (side + arc) * 4 * i / 160 + arc + 3;
    const int quarter = static_cast<int>(at / (side + arc));
    const double rest = at - quarter * (side + arc), angle = std::min(rest, arc) / 8;
    const Vec3d on_first(24 + 8 * std::cos(angle), 24 + 8 * std::sin(angle), 0);
    const Vec3d place = on_first - Vec3d(std::max(rest - arc, 0.), 0, 0);
    pen.push_back(Eigen::AngleAxisd(quarter * std::numbers::pi / 2, Vec3d::UnitZ()) * place);
  }
  const SnapResult result = scene.snap_closed(pen, {FeatureKind::ridge}, {.radius = 12});
  EXPECT_TRUE(result.curve.closed);
  double most = 0;
  for (const CurvePoint& point : result.curve.points)
    most = std::max(most, distance(static_cast<double>(point.at.position.x()),
                                   static_cast<double>(point.at.position.y())));
  EXPECT_LT(most, 1.6);
  for (const double x : {-35., 35.})
    for (const double y : {-35., 35.}) {
      double nearest = 1e9;
      for (const CurvePoint& point : result.curve.points)
        nearest = std::min(nearest, std::hypot(static_cast<double>(point.at.position.x()) - x,
                                               static_cast<double>(point.at.position.y()) - y));
      EXPECT_LT(nearest, 1.2) << x << ' ' << y;
    }
  EXPECT_NEAR(result.curve.length(), 280, 4);
}

/// Places 1 apart on two legs that meet at the origin at this turn.
std::vector<LinePlace> places_around(double turn) {
  std::vector<LinePlace> places;
  for (int i = -8; i <= 8; ++i) {
    const Vec3d leg = BentLine{turn}.leg(i < 0 ? -1 : 1);
    const Vec3d rounded(0, i == 0 ? -0.4 : 0, 0);
    places.push_back({10. + i, std::abs(i) * leg + rounded, std::abs(i) < 2 ? 0.4 : 0});
  }
  return places;
}

TEST(Corners, AreWhereLegsMeet) {
  const std::vector<Corner> corners = corners_of(places_around(60 * degree), 1);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_NEAR(corners[0].t, 10, 1);
  EXPECT_NEAR(corners[0].position.norm(), 0, 1e-9)
      << "the place at the corner, which is rounded, is left out";
  EXPECT_TRUE(corners_of(places_around(15 * degree), 1).empty());
  EXPECT_TRUE(corners_of({}, 1).empty());
}

}  // namespace
}  // namespace burin::test
