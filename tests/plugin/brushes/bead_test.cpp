#include <cmath>
#include <numbers>

#include "stock_brush.h"

namespace burin {
namespace {

using test::Displaced;
using test::Nodes;
using test::steps;
using test::Vector;

enum Form { rod, beads };

class Bead : public test::StockBrush {
 protected:
  Bead() : StockBrush("bead") { stroke_.params.set("width", 0.8f); }

  /// Counts the runs of points along the stroke's middle with a displacement.
  int beads_along(float last) {
    int count = 0;
    bool inside = false;
    Nodes nodes{steps(5000, last), std::vector<float>(5001, 0)};
    for (float& t : nodes.t) t -= 1;
    for (const float up : evaluate(nodes).up) {
      count += up > 0.1f && !inside;
      inside = up > 0.1f;
    }
    return count;
  }
};

TEST_F(Bead, IsAHalfCircleAcross) {
  for (const float d : steps(100, 0.8f)) {
    const Vector moved = at(5, d);
    EXPECT_NEAR(std::hypot(d + moved.y, moved.z), 0.8f, 1e-6f) << d;
    EXPECT_GE(moved.z, 0);
    const float angle = std::atan2(d + moved.y, moved.z);
    EXPECT_NEAR(angle, std::numbers::pi_v<float> / 2 * d / 0.8f, 1e-5f) << "evenly spread";
  }
  EXPECT_EQ(at(5, 0.81f).z, 0);
}

TEST_F(Bead, EndsInQuarterSpheres) {
  for (int i = 0; i < 500; ++i) {
    const float angle = random(-1.5f, 1.5f), distance = random(0, 0.8f);
    const float beyond = distance * std::cos(angle), d = distance * std::sin(angle);
    const Vector end = at(10 + beyond, d), start = at(-beyond, d);
    EXPECT_NEAR(std::hypot(beyond + end.x, d + end.y, end.z), 0.8f, 1e-5f);
    EXPECT_NEAR(start.x, -end.x, 1e-5f);
    EXPECT_NEAR(start.z, end.z, 1e-5f);
  }
}

TEST_F(Bead, IsAHalfSphereAsADab) {
  stroke_.context.flags = BURIN_STROKE_DAB | BURIN_STROKE_FINAL;
  stroke_.context.length = 0;
  for (const float form : {rod, beads}) {
    stroke_.params.set("form", form);
    const Vector moved = at(-0.3f, 0.4f);
    EXPECT_NEAR(std::hypot(-0.3f + moved.x, 0.4f + moved.y, moved.z), 0.8f, 1e-6f);
  }
}

TEST_F(Bead, StringsWholeBeads) {
  stroke_.params.set("form", beads);
  const Vector moved = at(1.9f, 0.2f);  // the second bead's middle is at 1.6
  EXPECT_NEAR(std::hypot(0.3f + moved.x, 0.2f + moved.y, moved.z), 0.8f, 1e-6f);
  EXPECT_EQ(beads_along(12), 7) << "at 0, 1.6 .. 9.6";
  EXPECT_GE(stroke_.plan.end_influence, 0.8);
  stroke_.context.length = 9.59;
  EXPECT_EQ(beads_along(12), 6);
  stroke_.params.set("spacing", 2);
  EXPECT_EQ(beads_along(12), 3) << "at 0, 3.2, 6.4";
}

TEST_F(Bead, StringsWholeBeadsAroundALoop) {
  stroke_.params.set("form", beads);
  stroke_.context.flags = BURIN_STROKE_CLOSED | BURIN_STROKE_FINAL;
  stroke_.context.length = 9.3;  // 5.8 beads: 6, which touch at half their distance of 1.55
  for (int bead = 0; bead < 6; ++bead) {
    EXPECT_NEAR(at(1.55f * static_cast<float>(bead), 0).z, 0.775f, 1e-5f);
    EXPECT_NEAR(at(1.55f * (static_cast<float>(bead) + 0.5f), 0).z, 0, 1e-5f);
  }
  expect_closed_seam();
}

TEST_F(Bead, HasNoStep) { expect_no_step(2.6f); }
TEST_F(Bead, HasNoStepBetweenBeads) {
  stroke_.params.set("form", beads);
  expect_no_step(2.6f);
}
TEST_F(Bead, HasNoSeam) { expect_closed_seam(); }
TEST_F(Bead, GrowsWithTheStroke) { expect_scale_invariance(); }
TEST_F(Bead, IsTheSameOnBothSides) { expect_same_on_both_sides(); }
TEST_F(Bead, IsFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
