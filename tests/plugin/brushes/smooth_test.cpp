#include "stock_brush.h"

namespace burin {
namespace {

using test::Displaced;
using test::Nodes;

enum Motion { free_motion, along_normal };

class Smooth : public test::StockBrush {
 protected:
  Smooth() : StockBrush("smooth") { stroke_.params.set("amount", 0.5f); }

  /// e1 is y and the normal -x, so that e2 = n x e1 is -z.
  void add_inputs(Nodes& nodes) override {
    const std::size_t n = nodes.t.size();
    nodes.e1.assign(n, {0, 1, 0});
    nodes.normal.assign(n, {-1, 0, 0});
    nodes.laplacian.assign(n, {0.1f * nodes.radius, 0.2f * nodes.radius, 0.3f * nodes.radius});
    nodes.displacement.assign(n, {0, 0, 0});
  }
};

TEST_F(Smooth, GoesAPartOfTheWayToTheNeighbours) {
  const test::Vector moved = at(5, 0);
  EXPECT_FLOAT_EQ(moved.x, 0.5f * 0.2f);
  EXPECT_FLOAT_EQ(moved.y, -0.5f * 0.3f);
  EXPECT_FLOAT_EQ(moved.z, -0.5f * 0.1f);
}

TEST_F(Smooth, GoesOnFromWhereThePassBeforeCameTo) {
  stroke_.params.set("passes", 7);
  Nodes nodes{{5}, {0}};
  add_inputs(nodes);
  nodes.displacement = {{1, 2, 3}};
  const Displaced moved = evaluate(nodes);
  EXPECT_FLOAT_EQ(moved.along[0], 1.1f);
  EXPECT_FLOAT_EQ(moved.across[0], 1.85f);
  EXPECT_FLOAT_EQ(moved.up[0], 2.95f);
  EXPECT_EQ(stroke_.plan.passes, 7u);
}

TEST_F(Smooth, MovesAlongTheNormalAlone) {
  stroke_.params.set("motion", along_normal);
  const test::Vector moved = at(5, 0);
  EXPECT_EQ(moved.x, 0);
  EXPECT_EQ(moved.y, 0);
  EXPECT_FLOAT_EQ(moved.z, -0.05f);
}

TEST_F(Smooth, HasItsSecondAxisOnTheRightWhenMirrored) {
  stroke_.context.flags = BURIN_STROKE_MIRRORED;
  EXPECT_FLOAT_EQ(at(5, 0).y, 0.5f * 0.3f);
  EXPECT_FLOAT_EQ(at(5, 0).x, 0.5f * 0.2f);
}

TEST_F(Smooth, FadesOutAtTheRim) {
  stroke_.params.set("fade", 0.5f);
  EXPECT_FLOAT_EQ(at(5, 0.75f).z, -0.025f);
  EXPECT_EQ(at(5, -1).z, 0);
  EXPECT_EQ(at(10.8f, 0.6f).z, 0);
}

TEST_F(Smooth, HasNoStep) { expect_no_step(0.6f); }
TEST_F(Smooth, GrowsWithTheStroke) {
  const test::Vector before = at(5, 0.8f);
  stroke_.context.radius_min = stroke_.context.radius_max = 2;
  stroke_.context.length = 20;
  const test::Vector after = at(10, 1.6f);
  EXPECT_FLOAT_EQ(after.x, 2 * before.x);
  EXPECT_FLOAT_EQ(after.z, 2 * before.z);
}
TEST_F(Smooth, IsFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
