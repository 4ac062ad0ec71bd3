#include <cmath>

#include "stock_brush.h"

namespace burin {
namespace {

class Crease : public test::StockBrush {
 protected:
  Crease() : StockBrush("crease") {}
};

TEST_F(Crease, IsDeepestInTheMiddleAndHasRaisedSides) {
  stroke_.params.set("depth", 0.5f);
  stroke_.params.set("sharpness", 4);
  stroke_.params.set("bulge", 0.3f);
  EXPECT_FLOAT_EQ(at(5, 0).z, -0.5f);
  EXPECT_FLOAT_EQ(at(5, 0.5f).z, 0.5f * (0.3f - 1.0f / 16));
  EXPECT_EQ(at(5, 1).z, 0);
  stroke_.params.set("depth", -0.5f);
  EXPECT_FLOAT_EQ(at(5, 0).z, 0.5f) << "a ridge";
}

TEST_F(Crease, HasACuspAlongTheMiddle) {
  stroke_.params.set("depth", 0.5f);
  stroke_.params.set("sharpness", 4);
  const float h = 1e-3f;
  const float slope = (at(5, h).z - at(5, 0).z) / h;
  EXPECT_NEAR(slope, 0.5f * 4, 0.02f) << "depth times sharpness";
  EXPECT_NEAR((at(5, -h).z - at(5, 0).z) / h, slope, 1e-3f) << "and down to it on the other side";
}

TEST_F(Crease, PinchesWithoutTurningTheSidesOver) {
  stroke_.params.set("pinch", 1);
  float before = 0;
  for (const float d : test::steps(1000, 1)) {
    const float moved = at(5, d).y;
    EXPECT_NEAR(moved, -d * (1 - d) * (1 - d), 1e-6f);
    EXPECT_GE(d + moved, before) << d;
    before = d + moved;
  }
}

TEST_F(Crease, FadesOutTowardsItsEnds) {
  stroke_.params.set("depth", 1);
  stroke_.params.set("taper", 4);
  EXPECT_EQ(at(0, 0).z, 0);
  EXPECT_EQ(at(-0.5f, 0).z, 0);
  EXPECT_FLOAT_EQ(at(2, 0).z, -0.5f);
  EXPECT_FLOAT_EQ(at(8, 0).z, -0.5f);
  EXPECT_EQ(stroke_.plan.end_influence, 4);
}

TEST_F(Crease, HasNoStep) { expect_no_step(2.5f); }
TEST_F(Crease, HasNoStepWithoutTaper) {
  stroke_.params.set("taper", 0);
  expect_no_step(2.5f);
}
TEST_F(Crease, HasNoSeam) { expect_closed_seam(); }
TEST_F(Crease, GrowsWithTheStroke) { expect_scale_invariance(); }
TEST_F(Crease, IsTheSameOnBothSides) { expect_same_on_both_sides(); }
TEST_F(Crease, IsFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
