#include <burin/chart/frames/circle_step.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

TEST(CircleStep, IsStraightWhereLinesAre) {
  const CircleStep step = circle_step(0.3F, -0.2F, 0, 0.5F);
  EXPECT_EQ(step.along, 0.3F);
  EXPECT_EQ(step.across, -0.2F);
  EXPECT_EQ(step.cosine, 1);
  EXPECT_EQ(step.sine, 0);
  EXPECT_EQ(step.size, 1);
}

// Around the corner at the origin the line at the distance 0.5 to the left bends to the right, k = -2.
TEST(CircleStep, GoesAroundACorner) {
  const float d = 0.5F, k = -1 / d;
  for (const double angle : {0.1, 0.7, 1.5}) {
    for (const double distance : {0.3, 0.5, 1.1}) {
      // The step leads from (0, d), where the line runs along x, to the given distance in the direction of
      // the angle.
      const double u = distance * std::sin(angle), v = distance * std::cos(angle) - static_cast<double>(d);
      const CircleStep step = circle_step(static_cast<float>(u), static_cast<float>(v), k, d);
      EXPECT_NEAR(d + step.across, distance, 1e-6);
      EXPECT_NEAR(step.along, static_cast<double>(d) * angle, 2e-5);
      EXPECT_NEAR(step.cosine, std::cos(angle), 1e-6);
      EXPECT_NEAR(step.sine, -std::sin(angle), 1e-6);
      EXPECT_NEAR(step.size, distance / static_cast<double>(d), 1e-6);
    }
  }
}

// Inside of a bend the distance goes on to rise beyond the centre, where that of the circle would fall.
TEST(CircleStep, GoesStraightPastAFocalPoint) {
  const float d = 0.4F, k = 10;
  const CircleStep step = circle_step(0.02F, 0.15F, k, d);
  EXPECT_EQ(step.across, 0.15F);
  EXPECT_EQ(step.along, 0.02F);
  EXPECT_EQ(step.size, 1);
}

TEST(CircleStep, HasNoGapBetweenSeriesAndArc) {
  const float k = -3, d = 0.3F, before = 0.0666F, after = 0.0667F;
  const CircleStep a = circle_step(before, 0, k, d), b = circle_step(after, 0, k, d);
  EXPECT_NEAR(b.along - a.along, after - before, 1e-5);
}

}  // namespace
}  // namespace burin
