#include <algorithm>
#include <cmath>

#include "stock_brush.h"

namespace burin {
namespace {

using test::Nodes;
using test::steps;

enum StitchPattern { straight, cross, zigzag };

class Stitches : public test::StockBrush {
 protected:
  Stitches() : StockBrush("stitches") {
    stroke_.params.set("length", 2);
    stroke_.params.set("thread", 0.15f);
    stroke_.params.set("pucker", 0.06f);
  }

  /// Threads on the way along the stroke at d.
  int threads_along(float d) {
    const auto length = static_cast<float>(stroke_.context.length);
    int count = 0;
    bool inside = false;
    for (const float up : evaluate({steps(5000, length), std::vector<float>(5001, d)}).up) {
      count += up > 0.1f && !inside;
      inside = up > 0.1f;
    }
    return count;
  }
};

TEST_F(Stitches, LayThreadBetweenHoles) {
  EXPECT_NEAR(at(1, 0).z, 0.15f + 0.06f, 1e-6f) << "half a thread above the cloth between the holes";
  const float cloth = 0.06f * (0.5f - 0.5f * std::cos(2 * 3.14159265f * 0.13f));
  EXPECT_NEAR(at(0.26f, 0).z, cloth - 0.6f * 0.15f, 1e-5f) << "the thread goes down";
  EXPECT_LT(at(0.26f - 0.12f, 0).z, -0.01f) << "the hole is wider";
  EXPECT_NEAR(at(1, 0.3f).z, 0.06f * (1 - 0.09f) * (1 - 0.09f), 1e-6f) << "the cloth alone";
  EXPECT_EQ(at(0, 0).z, 0);
}

TEST_F(Stitches, ComeInWholeNumbers) {
  EXPECT_EQ(threads_along(0), 5);
  EXPECT_GE(stroke_.plan.end_influence, 2);
  stroke_.context.length = 9.9;
  EXPECT_EQ(threads_along(0), 4);
  EXPECT_EQ(at(9, 0).z, 0) << "no hole where no stitch fits";
  stroke_.context.flags = BURIN_STROKE_CLOSED | BURIN_STROKE_FINAL;
  EXPECT_EQ(threads_along(0), 5);
}

TEST_F(Stitches, CrossOverEachOther) {
  stroke_.params.set("pattern", cross);
  stroke_.params.set("pucker", 0);
  stroke_.params.set("thread", 0.1f);
  EXPECT_NEAR(at(1, 0).z, 0.2f, 1e-6f) << "the second thread lies on the first";
  const float u = 0.33f, v = 0.308f;  // of the way from the crossing to the holes a little more than half
  EXPECT_NEAR(at(1 + u, v).z, 0.1f, 1e-5f);
  EXPECT_NEAR(at(1 + u, -v).z, 0.1f, 1e-5f);
  EXPECT_NEAR(at(1 - u, v).z, 0.1f, 1e-5f);
  EXPECT_LT(at(1.45f, 0).z, 1e-6f) << "nothing between the arms";
}

TEST_F(Stitches, ZigzagFromSideToSide) {
  stroke_.params.set("pattern", zigzag);
  stroke_.params.set("pucker", 0);
  EXPECT_NEAR(at(0.52f, 0).z, 0.15f, 1e-5f);
  EXPECT_NEAR(at(1.48f, 0).z, 0.15f, 1e-5f);
  EXPECT_GT(at(0.38f, -0.28f).z, 0.1f);
  EXPECT_LE(at(0.38f, 0.28f).z, 0);
}

TEST_F(Stitches, LieInRows) {
  stroke_.params.set("rows", 2);
  EXPECT_EQ(threads_along(0.4f), 5);
  EXPECT_EQ(threads_along(-0.4f), 5);
  EXPECT_EQ(threads_along(0), 0);
}

TEST_F(Stitches, PutOneStitchIntoADab) {
  stroke_.context.flags = BURIN_STROKE_DAB | BURIN_STROKE_FINAL;
  stroke_.context.length = 0;
  EXPECT_GT(at(0, 0).z, 0.1f);
  EXPECT_LT(at(-0.6f, 0).z, -0.01f);
  EXPECT_LT(at(0.6f, 0).z, -0.01f);
}

TEST_F(Stitches, HaveNoStep) {
  for (const float pattern : {straight, cross, zigzag}) {
    for (const float rows : {1.0f, 3.0f}) {
      SCOPED_TRACE(testing::Message() << "pattern " << pattern << ", rows " << rows);
      stroke_.params.set("pattern", pattern);
      stroke_.params.set("rows", rows);
      stroke_.params.set("thread", 0.25f);
      expect_no_step(5);
    }
  }
}
TEST_F(Stitches, HaveNoSeam) {
  for (const float pattern : {straight, cross, zigzag}) {
    stroke_.params.set("pattern", pattern);
    stroke_.params.set("length", 0.7f);
    stroke_.context.flags = BURIN_STROKE_CLOSED | BURIN_STROKE_FINAL;
    stroke_.context.length = 10;  // 14 tiles of 10 / 14
    for (const float d : steps(20, 1)) EXPECT_NEAR(at(1, d).z, at(1 + 50.0f / 7, d).z, 2e-5f);
  }
}
TEST_F(Stitches, GrowWithTheStroke) { expect_scale_invariance(); }
TEST_F(Stitches, AreTheSameOnBothSides) { expect_same_on_both_sides(); }
TEST_F(Stitches, AreFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
