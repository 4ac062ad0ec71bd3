#include <burin/chart/path/stroke_path.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double radius = 0.2;

/// A curve over the plane, of so many samples of a bow.
SurfaceCurve bow(int samples) {
  const Surface surface = make_surface(test::plane(1, 0.02, 3));
  const Picker picker(surface);
  std::vector<Vec3d> places;
  for (int i = 0; i < samples; ++i) places.emplace_back(-0.6 + 0.03 * i, 0.2 * std::sin(0.1 * i), 0);
  return test::traced(surface, picker, radius, places);
}

StrokePath path_of(const SurfaceCurve& curve) {
  GeodesicCurvature curvature;
  curvature.update(curve, radius / 4);
  StrokePath path;
  path.update(curve, curvature, radius, 0, 0);
  return path;
}

TEST(StrokePath, TellsDistances) {
  const StrokePath path = path_of(bow(30));
  EXPECT_EQ(path.chart_distance(0.3, -0.1), 0.1);
  EXPECT_NEAR(path.chart_distance(-0.3, 0.4), 0.5, 1e-12);
  EXPECT_NEAR(path.chart_distance(path.length() + 0.3, 0.4), 0.5, 1e-12);
}

// Coordinates of points of the curve itself: d = 0 is right, and at another t false by how far that is.
TEST(StrokePath, FindsFalseCoordinates) {
  const SurfaceCurve curve = bow(30);
  const StrokePath path = path_of(curve);
  for (const CurvePoint& point : curve.points) {
    const Vec3f& x = point.at.position;
    EXPECT_EQ(path.excess(point.t, 0, x), 0);
    EXPECT_EQ(path.distance(point.t, 0, x), 0);
    const double elsewhere = point.t < path.length() / 2 ? point.t + 0.1 : point.t - 0.1;
    EXPECT_NEAR(path.excess(elsewhere, 0, x), 0.1, 0.01);
    EXPECT_NEAR(path.distance(elsewhere, 0, x), 0.1, 0.01);
    EXPECT_EQ(path.excess(elsewhere, 0.2, x), 0);
  }
}

TEST(StrokePath, GrowsToTheSameBits) {
  const SurfaceCurve whole = bow(30);
  SurfaceCurve part = bow(18);
  std::size_t unchanged = 0;
  while (unchanged < part.points.size() && part.points[unchanged].t == whole.points[unchanged].t &&
         part.points[unchanged].at.position == whole.points[unchanged].at.position)
    ++unchanged;
  ASSERT_GT(unchanged, 20U);
  GeodesicCurvature curvature;
  curvature.update(part, radius / 4);
  StrokePath grown;
  grown.update(part, curvature, radius, 0, 0);
  const std::size_t bent = curvature.update(whole, radius / 4, unchanged);
  grown.update(whole, curvature, radius, 0, std::min(bent, unchanged));
  const StrokePath fresh = path_of(whole);
  for (double t = -0.1; t < whole.length() + 0.1; t += 0.003) {
    EXPECT_EQ(grown.distance(t, 0.01, Vec3f(0.1F, 0.3F, 0)), fresh.distance(t, 0.01, Vec3f(0.1F, 0.3F, 0)));
    EXPECT_EQ(grown.curvature(t), fresh.curvature(t));
  }
}

TEST(StrokePath, TakesCoordinatesThatAreNoNumbers) {
  const StrokePath path = path_of(bow(30));
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(path.excess(none, none, Vec3f::Zero()), 0);
}

}  // namespace
}  // namespace burin
