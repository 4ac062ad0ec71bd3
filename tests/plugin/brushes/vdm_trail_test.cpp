#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plugin/driver.h"

namespace burin {
namespace {

using test::Nodes;

/// A map that tells places apart: red u, green v, blue u + v, and one that is too simple.
class VdmTrail : public testing::Test {
 protected:
  VdmTrail() {
    host_.pictures["map"] = {64, 64, 3, [](std::uint32_t channel, double u, double v) {
                               return static_cast<float>(channel == 0 ? u : channel == 1 ? v : u + v);
                             }};
    stroke_.params.set_file("stamp", "map");
    stroke_.context.flags = BURIN_STROKE_FINAL;
  }

  struct Moved {
    float along, across, up;
  };
  Moved moved(float t, float d, float radius = 1) {
    stroke_.end();
    const test::Answer began = stroke_.begin();
    EXPECT_EQ(began.status, BURIN_OK) << began.text;
    EXPECT_EQ(stroke_.evaluate(Nodes{{t}, {d}, radius}).status, BURIN_OK);
    return {stroke_.along[0], stroke_.across[0], stroke_.up[0]};
  }

  test::PluginModule module_{"brushes/vdm_trail"};
  test::TestHost host_;
  test::StrokeDriver stroke_{module_, "org.burin.vdm-trail", host_.abi};
};

void expect_near(const auto& a, double along, double across, double up) {
  EXPECT_NEAR(a.along, along, 1e-5);
  EXPECT_NEAR(a.across, across, 1e-5);
  EXPECT_NEAR(a.up, up, 1e-5);
}

TEST_F(VdmTrail, MovesRightUpAndOutwardInHalvesOfTheStampsWidth) {
  // Stamps of width 2 around 0, 2, 4...: t = 4.5 is u = 0.75, d = 0.6 is v = 0.2.
  expect_near(moved(4.5f, 0.6f), 0.75, 0.2, 0.95);
  expect_near(moved(4.5f, 0.3f, 0.5f), 0.375, 0.1, 0.475);
  stroke_.params.set("size", 1);  // around 0, 1, 2...
  expect_near(moved(4.25f, 0.3f), 0.375, 0.1, 0.475);
  stroke_.params.set("amount", -2);
  expect_near(moved(4.25f, 0.3f), -0.75, -0.2, -0.95);
}

TEST_F(VdmTrail, LeavesTheSurfaceAloneBetweenStamps) {
  stroke_.params.set("size", 1);
  stroke_.params.set("gap", 0.5f);  // around 0, 1.5, 3...
  expect_near(moved(3.25f, 0.3f), 0.375, 0.1, 0.475);
  expect_near(moved(3.7f, 0), 0, 0, 0);
  expect_near(moved(3, 0.6f), 0, 0, 0);
}

TEST_F(VdmTrail, TurnsAndMirrorsVectorsWithTheStamp) {
  stroke_.params.set("angle", std::numbers::pi_v<float> / 2);
  // The stamp's right points to the left of the travel: the place is 0.6 to its right, 0.5 below its middle.
  expect_near(moved(4.5f, 0.6f), -0.75, 0.8, 1.55);
  stroke_.params.set("angle", 0);
  stroke_.params.set("mirror", 1);
  expect_near(moved(4.5f, 0.6f), 0.75, 0.2, 0.95);
  expect_near(moved(2.5f, 0.6f), -0.25, 0.2, 0.45);
  stroke_.params.set("mirror", 0);
  stroke_.params.set("flip", 1);
  int flipped = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    stroke_.context.seed = seed;
    const Moved at = moved(4.5f, 0.6f);
    if (at.across < 0) {
      ++flipped;
      expect_near(at, 0.75, -0.8, 1.55);
    } else {
      expect_near(at, 0.75, 0.2, 0.95);
    }
  }
  EXPECT_NEAR(flipped, 100, 42);
}

TEST_F(VdmTrail, PutsAStampWhereTheStrokeReachesItsMiddle) {
  stroke_.context.length = 3.9;
  expect_near(moved(2.5f, 0), 0.75, 0.5, 1.25);
  expect_near(moved(3.5f, 0), 0, 0, 0);
  EXPECT_EQ(stroke_.plan.end_influence, 1);
  stroke_.context.length = 4;
  expect_near(moved(3.5f, 0), 0.25, 0.5, 0.75);
  stroke_.context.length = 0;
  expect_near(moved(0.5f, 0), 0.75, 0.5, 1.25);
  stroke_.context.flags |= BURIN_STROKE_DAB;
  stroke_.context.dab_t = 5.3;
  expect_near(moved(0.5f, 0), 0.75, 0.5, 1.25);
}

TEST_F(VdmTrail, AsksForThreeChannels) {
  stroke_.params.set_file("stamp", "ramp.exr");
  const test::Answer answer = stroke_.begin();
  EXPECT_EQ(answer.status, BURIN_ERROR);
  EXPECT_EQ(answer.text, "ramp.exr: a vector displacement map has three channels");
  EXPECT_EQ(host_.open_stamps, 0);
}

}  // namespace
}  // namespace burin
