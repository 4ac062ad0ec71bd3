#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stock_brush.h"

namespace burin {
namespace {

using test::Nodes;
using test::steps;

enum Profile { round_profile, v_profile, flat_profile };

class Groove : public testing::Test {
 protected:
  test::PluginModule module_{"brushes/groove"};
  test::TestHost host_;
  test::StrokeDriver stroke_{module_, "org.burin.groove", host_.abi};

  std::vector<float> evaluate(const Nodes& nodes) {
    stroke_.end();
    EXPECT_EQ(stroke_.begin().status, BURIN_OK);
    EXPECT_EQ(stroke_.evaluate(nodes).status, BURIN_OK);
    return stroke_.up;
  }

  float depth_at(float t, float d) { return -evaluate({{t}, {d}})[0]; }
};

TEST_F(Groove, IsAsDeepAsItsParameterSaysInTheMiddle) {
  stroke_.params.set("depth", 0.5f);
  stroke_.params.set("taper", 1);
  stroke_.context.radius_min = stroke_.context.radius_max = 3;
  for (const float profile : {round_profile, v_profile, flat_profile}) {
    stroke_.params.set("profile", profile);
    EXPECT_FLOAT_EQ(evaluate({{5.0f}, {0.0f}, 3.0f})[0], -1.5f) << profile;
    EXPECT_EQ(stroke_.along[0], 0);
    EXPECT_EQ(stroke_.across[0], 0);
  }
}

TEST_F(Groove, FallsToTheRimWithoutAStep) {
  stroke_.params.set("depth", 1);
  stroke_.params.set("width", 0.5f);
  for (const float profile : {round_profile, v_profile, flat_profile}) {
    SCOPED_TRACE(profile);
    stroke_.params.set("profile", profile);
    const std::vector<float> d = steps(1000, 1);
    const std::vector<float> up = evaluate({std::vector<float>(d.size(), 5), d});
    for (std::size_t i = 1; i < d.size(); ++i) {
      EXPECT_GE(up[i], up[i - 1]);
      EXPECT_LT(up[i] - up[i - 1], 0.0061f) << "at most 1.5 / 0.25 times the step of 0.001";
      EXPECT_EQ(up[i] == 0, d[i] >= 0.5f) << d[i];
    }
    const std::size_t rim = 500;
    EXPECT_NEAR(up[rim - 1], 0, 1e-4) << "the tangent at the rim is level";
    EXPECT_LT(up[rim - 100], -0.03f);
    EXPECT_EQ(evaluate({std::vector<float>(d.size(), 5), d}), up);
  }
}

TEST_F(Groove, IsTheSameOnBothSides) {
  for (const float d : steps(20, 1)) EXPECT_EQ(depth_at(5, d), depth_at(5, -d));
}

TEST_F(Groove, ProfilesDiffer) {
  std::vector<float> depths;
  for (const float profile : {v_profile, round_profile, flat_profile}) {
    stroke_.params.set("profile", profile);
    depths.push_back(depth_at(5, 0.4f));
  }
  EXPECT_LT(depths[0], depths[1]);
  EXPECT_LT(depths[1], depths[2]);
}

TEST_F(Groove, RisesToTheSurfaceAtBothEnds) {
  stroke_.params.set("taper", 3);
  EXPECT_EQ(depth_at(0, 0), 0);
  EXPECT_EQ(depth_at(10, 0), 0);
  EXPECT_EQ(depth_at(-0.5f, 0), 0);
  EXPECT_EQ(depth_at(10.5f, 0), 0);
  EXPECT_FLOAT_EQ(depth_at(1.5f, 0), 0.125f) << "half of the depth in the middle of the taper";
  EXPECT_FLOAT_EQ(depth_at(8.5f, 0), 0.125f);
  EXPECT_FLOAT_EQ(depth_at(3, 0), 0.25f);
  EXPECT_FLOAT_EQ(depth_at(7, 0), 0.25f);
}

TEST_F(Groove, HasNoEndsWhenClosed) {
  stroke_.context.flags = BURIN_STROKE_CLOSED;
  EXPECT_FLOAT_EQ(depth_at(0, 0), 0.25f);
  EXPECT_FLOAT_EQ(depth_at(10, 0), 0.25f);
}

TEST_F(Groove, WithoutTaperIsRoundAtItsEnds) {
  stroke_.params.set("taper", 0);
  const float beside = depth_at(5, 0.6f);
  ASSERT_GT(beside, 0.05f);
  for (const float angle : steps(8, std::numbers::pi_v<float> / 2)) {
    EXPECT_NEAR(depth_at(10 + 0.6f * std::cos(angle), 0.6f * std::sin(angle)), beside, 1e-5);
    EXPECT_NEAR(depth_at(-0.6f * std::cos(angle), 0.6f * std::sin(angle)), beside, 1e-5);
  }
}

TEST_F(Groove, KeepsWhatLiesFartherBackThanItsEndInfluence) {
  stroke_.params.set("taper", 2.5f);
  const Nodes nodes{steps(1000, 10), std::vector<float>(1001, 0.3f)};
  const auto before = evaluate(nodes);
  EXPECT_EQ(stroke_.plan.end_influence, 2.5);
  stroke_.context.length = 14;
  const auto after = evaluate(nodes);
  int kept = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (nodes.t[i] > 10 - stroke_.plan.end_influence) continue;
    EXPECT_EQ(before[i], after[i]) << nodes.t[i];
    ++kept;
  }
  EXPECT_GT(kept, 700);
  EXPECT_NE(before[900], after[900]) << "the end influences something";
}

TEST_F(Groove, ReadsUniformAndVaryingDepthAlike) {
  const Nodes nodes{steps(50, 10), std::vector<float>(51, 0.2f)};
  stroke_.params.set("depth", 0.7f);
  const auto uniform = evaluate(nodes);
  std::vector<float> every_second(102, 99.0f);
  for (std::size_t i = 0; i < 51; ++i) every_second[2 * i] = 0.7f;
  stroke_.end();
  ASSERT_EQ(stroke_.begin().status, BURIN_OK);
  stroke_.params.set("depth", every_second, 2);
  ASSERT_EQ(stroke_.evaluate(nodes).status, BURIN_OK);
  EXPECT_EQ(stroke_.up, uniform);

  std::vector<float> rising = steps(50, 1);
  stroke_.params.set("depth", rising, 1);
  ASSERT_EQ(stroke_.evaluate(nodes).status, BURIN_OK);
  for (std::size_t i = 0; i < 51; ++i) EXPECT_NEAR(stroke_.up[i], uniform[i] / 0.7f * rising[i], 1e-6);
}

}  // namespace
}  // namespace burin
