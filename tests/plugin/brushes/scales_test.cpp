#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "plugin/driver.h"

namespace burin {
namespace {

using test::Nodes;
using test::TestHost;

class Scales : public testing::Test {
 protected:
  Scales() { stroke_.params.set_file("stamp", "ramp.exr"); }

  test::PluginModule module_{"brushes/scales"};
  TestHost host_;
  test::StrokeDriver stroke_{module_, "org.burin.scales", host_.abi};

  std::vector<float> evaluate(const Nodes& nodes) {
    stroke_.end();
    EXPECT_EQ(stroke_.begin().status, BURIN_OK);
    EXPECT_EQ(stroke_.evaluate(nodes).status, BURIN_OK);
    return stroke_.up;
  }
};

/// Places away from where the ramp jumps, off the ends of a stroke of length 10 and radius 1.
Nodes random_nodes(std::size_t count) {
  const unsigned seed = std::random_device{}();
  testing::Test::RecordProperty("seed", static_cast<int>(seed));
  std::cout << "seed " << seed << '\n';
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> along(0, 10), across(-1, 1);
  Nodes nodes;
  for (std::size_t i = 0; i < count; ++i) {
    nodes.t.push_back(along(engine));
    nodes.d.push_back(across(engine));
  }
  return nodes;
}

/// The distance of u from the next whole number.
double from_jump(double u) { return std::abs(u - std::round(u)); }

TEST_F(Scales, TilesTheStampInTAndD) {
  stroke_.params.set("depth", 2);
  stroke_.params.set("centre", 0.75f);
  stroke_.params.set("tile", 0.8f);
  stroke_.params.set("fade", 0.3f);
  const Nodes nodes = random_nodes(3000);  // more than one block of samples, not a whole number of them
  const auto up = evaluate(nodes);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < up.size(); ++i) {
    const double u = nodes.t[i] / 0.8;
    const double v = 0.5 - nodes.d[i] / 0.4;  // the image is half as high as it is wide
    const double x = std::clamp((1 - std::abs(nodes.d[i])) / 0.3, 0.0, 1.0);
    if (from_jump(u) < 1e-4 || from_jump(v) < 1e-4) continue;
    EXPECT_NEAR(up[i], 2 * (TestHost::ramp(u, v) - 0.75) * x * x * (3 - 2 * x), 2e-5);
    ++checked;
  }
  EXPECT_GT(checked, 2900u);
}

TEST_F(Scales, StretchesTilesAcrossByAspect) {
  stroke_.params.set("aspect", 3);
  stroke_.params.set("tile", 1);
  stroke_.params.set("depth", 1);
  stroke_.params.set("centre", 0);
  EXPECT_NEAR(evaluate({{0.25f}, {0.3f}})[0], 0.25 + 2 * (0.5 - 0.3 / 1.5), 1e-5);
}

TEST_F(Scales, LeavesTheSurfaceAloneAtTheRim) {
  stroke_.params.set("centre", -1);
  const auto up = evaluate({{5, 5, 10.6f, -0.8f, 5, 5}, {1, -1, 0.8f, 0.6f, 0.999f, 0}});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(up[i], 0, 1e-6) << i;
  EXPECT_GT(up[4], 0);
  EXPECT_LT(up[4], 1e-4);
  EXPECT_GT(up[5], 0.25f);
}

TEST_F(Scales, FitsWholeTilesIntoALoop) {
  stroke_.context.flags = BURIN_STROKE_CLOSED;
  stroke_.params.set("tile", 3);  // 10 / 3: three tiles of 10 / 3
  stroke_.params.set("depth", 1);
  stroke_.params.set("centre", 0);
  const auto up = evaluate({{1, 1 + 10.0f / 3, 9.999f, 10.001f}, {0.1f, 0.1f, 0.1f, 0.1f}});
  EXPECT_NEAR(up[0], up[1], 1e-5);
  EXPECT_NEAR(up[2] - up[3], 1, 1e-3) << "a tile ends where the loop does";
  EXPECT_EQ(stroke_.plan.end_influence, std::numeric_limits<double>::infinity());
}

TEST_F(Scales, DoesNotDependOnTheEndOfAnOpenStroke) {
  const Nodes nodes = random_nodes(200);
  const auto before = evaluate(nodes);
  EXPECT_EQ(stroke_.plan.end_influence, 0);
  stroke_.context.length = 12;
  EXPECT_EQ(evaluate(nodes), before);
}

TEST_F(Scales, MovesMirrorsAndFlipsItsTiles) {
  stroke_.params.set("tile", 2);
  stroke_.params.set("depth", 1);
  stroke_.params.set("centre", 0);
  const Nodes nodes{{2.5f}, {0.2f}};  // tiles are 1 wide: u = 0.25 of column 1, v = 0.3 of row 0
  EXPECT_NEAR(evaluate(nodes)[0], TestHost::ramp(0.25, 0.3), 1e-5);
  stroke_.params.set("offset_along", 0.125f);
  stroke_.params.set("offset_across", 0.1f);
  EXPECT_NEAR(evaluate(nodes)[0], TestHost::ramp(0.125, 0.2), 1e-5);
  stroke_.params.set("offset_along", 0);
  stroke_.params.set("offset_across", 0);
  stroke_.params.set("mirror", 1);
  EXPECT_NEAR(evaluate(nodes)[0], TestHost::ramp(0.75, 0.3), 1e-5);
  EXPECT_EQ(host_.stamps.back().wrap_u, BURIN_WRAP_MIRROR);
  stroke_.params.set("mirror", 0);
  stroke_.params.set("flip", 1);
  int flipped = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    stroke_.context.seed = seed;
    const float up = evaluate(nodes)[0];
    const bool turned = std::abs(up - TestHost::ramp(0.25, 0.7)) < 1e-5;
    EXPECT_TRUE(turned || std::abs(up - TestHost::ramp(0.25, 0.3)) < 1e-5);
    flipped += turned;
  }
  EXPECT_NEAR(flipped, 100, 42);
}

TEST_F(Scales, JoinsMirroredTilesWithoutASeam) {
  host_.pictures["slope"] = {64, 32, 1,
                             [](std::uint32_t, double u, double v) { return static_cast<float>(u + 2 * v); }};
  stroke_.params.set_file("stamp", "slope");
  stroke_.params.set("tile", 0.9f);
  stroke_.params.set("depth", 1);
  stroke_.params.set("mirror", 1);
  const auto greatest_step = [&] {
    Nodes nodes;
    for (float t = 0; t < 10; t += 1e-5f) nodes.t.push_back(t), nodes.d.push_back(0.1f);
    const auto up = evaluate(nodes);
    float step = 0;
    for (std::size_t i = 1; i < up.size(); ++i) step = std::max(step, std::abs(up[i] - up[i - 1]));
    return step;
  };
  EXPECT_LE(greatest_step(), 1e-4);
  stroke_.context.flags = BURIN_STROKE_CLOSED;
  stroke_.params.set("tile", 1.4f);  // 7 tiles before the loop makes them even
  EXPECT_LE(greatest_step(), 1e-4);
  EXPECT_NEAR(evaluate({{0}, {0.1f}})[0], evaluate({{std::nextafter(10.0f, 0.0f)}, {0.1f}})[0], 1e-4);
  stroke_.params.set("mirror", 0);
  EXPECT_GT(greatest_step(), 0.5) << "the slope jumps where it is not mirrored";
}

TEST_F(Scales, KeepsTheStampOpenWhileTheStrokeIs) {
  ASSERT_EQ(stroke_.begin().status, BURIN_OK);
  EXPECT_EQ(host_.open_stamps, 1);
  stroke_.end();
  EXPECT_EQ(host_.open_stamps, 0);
}

TEST_F(Scales, PassesOnWhyAFileCannotBeOpened) {
  stroke_.params.set_file("stamp", "missing.exr");
  const test::Answer answer = stroke_.begin();
  EXPECT_EQ(answer.status, BURIN_NOT_FOUND);
  EXPECT_EQ(answer.text, "missing.exr: no such file");
  EXPECT_EQ(host_.open_stamps, 0);
}

TEST_F(Scales, SaysSoWhenTheHostHasNoStamps) {
  host_.withholds_services = true;
  const test::Answer answer = stroke_.begin();
  EXPECT_EQ(answer.status, BURIN_UNSUPPORTED);
  EXPECT_EQ(answer.text, "this host cannot sample stamps");
}

}  // namespace
}  // namespace burin
