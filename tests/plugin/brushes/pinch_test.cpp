#include "stock_brush.h"

namespace burin {
namespace {

using test::Displaced;

class Pinch : public test::StockBrush {
 protected:
  Pinch() : StockBrush("pinch") {}
};

TEST_F(Pinch, DrawsTowardsTheStrokeAndNeverAcross) {
  for (const float amount : {1.0f, 0.6f, -1.0f}) {
    stroke_.params.set("amount", amount);
    float before = 0;
    for (const float d : test::steps(1000, 1)) {
      const float moved = at(5, d).y;
      EXPECT_NEAR(moved, -amount * d * (1 - d) * (1 - d), 1e-6f);
      EXPECT_GE(d + moved, before) << "points keep their order";
      before = d + moved;
    }
  }
  EXPECT_EQ(at(5, 0.4f).x, 0);
  EXPECT_EQ(at(5, 0.4f).z, 0);
}

TEST_F(Pinch, DrawsTowardsTheEndsWithinCaps) {
  const test::Vector moved = at(10.3f, 0.4f);
  EXPECT_NEAR(moved.x, -0.75f * 0.25f * 0.3f, 1e-6f);
  EXPECT_NEAR(moved.y, -0.75f * 0.25f * 0.4f, 1e-6f);
  EXPECT_NEAR(at(-0.3f, 0.4f).x, -moved.x, 1e-6f);
}

// Inside of a bend of radius 0.5 the stretch is 1 - 2 d.
TEST_F(Pinch, PullsToNoSideAtTheCentreOfABend) {
  for (const float amount : {1.0f, -1.0f}) {
    stroke_.params.set("amount", amount);
    float before = 0;
    for (const float d : test::steps(1000, 0.5f)) {
      const float moved = evaluate({.t = {5}, .d = {d}, .stretch = 1 - 2 * d}).across[0];
      EXPECT_NEAR(moved, -amount * d * (1 - d) * (1 - d) * (1 - 2 * d), 1e-6f);
      EXPECT_GE(d + moved, before) << "points keep their order";
      before = d + moved;
    }
    EXPECT_EQ(before, 0.5f);
  }
}

// Outside of a bend the stretch is greater than 1.
TEST_F(Pinch, PullsNoFartherOutsideOfABend) {
  const Displaced bend = evaluate({.t = {5}, .d = {0.4f}, .stretch = 1.8f});
  EXPECT_EQ(bend.across[0], at(5, 0.4f).y);
}

TEST_F(Pinch, Lifts) {
  stroke_.params.set("lift", 0.5f);
  EXPECT_FLOAT_EQ(at(5, 0).z, 0.5f);
  EXPECT_FLOAT_EQ(at(5, 0.5f).z, 0.25f);
  EXPECT_EQ(at(5, 1).z, 0);
  EXPECT_EQ(at(5, 0).y, 0);
}

TEST_F(Pinch, HasNoStep) {
  stroke_.params.set("lift", 0.5f);
  expect_no_step(1.5f);
}
TEST_F(Pinch, HasNoSeam) {
  stroke_.params.set("lift", 0.5f);
  expect_closed_seam();
}
TEST_F(Pinch, GrowsWithTheStroke) {
  stroke_.params.set("lift", 0.5f);
  expect_scale_invariance();
}
TEST_F(Pinch, IsTheSameOnBothSides) { expect_same_on_both_sides(); }
TEST_F(Pinch, IsFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
