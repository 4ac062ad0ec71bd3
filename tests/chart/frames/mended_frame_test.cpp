#include <burin/chart/frames/mended_frame.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double radius = 0.2;

/// A stroke on the plane from (-0.6, 0) to the origin, and from there down: a corner to the right.
FrontStroke cornered() {
  const Surface surface = make_surface(test::plane(1, 0.02, 3));
  const Picker picker(surface);
  std::vector<Vec3d> places;
  for (int i = -20; i <= 0; ++i) places.emplace_back(0.03 * i, 0, 0);
  for (int i = 1; i <= 20; ++i) places.emplace_back(0, -0.03 * i, 0);
  FrontStroke stroke;
  stroke.radius = radius;
  stroke.curve = test::traced(surface, picker, radius, places);
  stroke.curvature.update(stroke.curve, radius / 4);
  stroke.samples.update(stroke.curve, radius, 0, {}, 0);
  stroke.path.update(stroke.curve, stroke.curvature, radius, 0, 0);
  return stroke;
}

GroundVertex on_plane(double x, double y) { return {Vec3d(x, y, 0).cast<float>(), Vec3f::UnitZ(), 0}; }

ChartFrame straight_frame(double t, double d) {
  return {.t = t, .d = static_cast<float>(d), .e1 = Vec3f::UnitX()};
}

TEST(MendedFrame, LeavesWhatIsTrue) {
  const FrontStroke stroke = cornered();
  const ChartFrame frame = straight_frame(0.3, 0.1);
  EXPECT_EQ(mended_frame(stroke, on_plane(-0.3, 0.1), frame).frame, frame);
}

// The first leg's coordinates, straight on past the corner, tell of a distance of 0.1 where it is 0.14.
TEST(MendedFrame, TakesTheStrokesOwnNearestPointWhereTheDistanceIsFalse) {
  const FrontStroke stroke = cornered();
  const double corner = 0.6;
  const MendedFrame mended = mended_frame(stroke, on_plane(0.1, 0.1), straight_frame(corner + 0.1, 0.1));
  EXPECT_NEAR(mended.frame.d, std::hypot(0.1, 0.1), 0.01 * radius);
  EXPECT_NEAR(mended.frame.t, corner, 0.1 * radius);
  // Along the circle around the corner, to the right.
  EXPECT_GT(mended.frame.e1.dot(Vec3f(1, -1, 0).normalized()), 0.98F);
  EXPECT_GT(mended.depends_to, corner + 0.1);
}

// Across a thin part the straight line is no way on the surface.
TEST(MendedFrame, LeavesWhatLooksTheOtherWay) {
  const FrontStroke stroke = cornered();
  GroundVertex below = on_plane(0.1, 0.1);
  below.normal = -below.normal;
  const ChartFrame frame = straight_frame(0.7, 0.1);
  EXPECT_EQ(mended_frame(stroke, below, frame).frame, frame);
}

TEST(MendedFrame, LeavesThePublishedMethodAsItIs) {
  FrontStroke stroke = cornered();
  stroke.order = 1;
  const ChartFrame frame = straight_frame(0.7, 0.1);
  EXPECT_EQ(mended_frame(stroke, on_plane(0.1, 0.1), frame).frame, frame);
}

}  // namespace
}  // namespace burin
