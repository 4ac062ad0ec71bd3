#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "plugin/driver.h"

namespace burin {
namespace {

using test::Nodes;

/// Stamps that tell themselves apart: u + 4 v and a multiple of 10.
class Tread : public testing::Test {
 protected:
  Tread() {
    float base = 0;
    for (const char* name : {"middle", "start", "end", "other"}) {
      host_.pictures[name] = {64, 64, 1, [base](std::uint32_t, double u, double v) {
                                return base + static_cast<float>(u + 4 * v);
                              }};
      base += 10;
    }
    stroke_.params.set_file("stamp", "middle");
    stroke_.params.set("height", 1);
    stroke_.params.set("tile", 2.4f);
    stroke_.context.flags = BURIN_STROKE_FINAL;
  }

  float height_at(float t, float d, float radius = 1) {
    stroke_.end();
    const test::Answer began = stroke_.begin();
    EXPECT_EQ(began.status, BURIN_OK) << began.text;
    EXPECT_EQ(stroke_.evaluate(Nodes{{t}, {d}, radius}).status, BURIN_OK);
    return stroke_.up[0];
  }

  test::PluginModule module_{"brushes/tread"};
  test::TestHost host_;
  test::StrokeDriver stroke_{module_, "org.burin.tread", host_.abi};
};

TEST_F(Tread, IsAsWideAsTheStroke) {
  EXPECT_NEAR(height_at(0.6f, 0), 0.25 + 2, 1e-5);
  EXPECT_NEAR(height_at(0.6f, 0.8f), 0.25 + 0.4, 1e-5);
  EXPECT_NEAR(height_at(0.6f, 0.4f, 0.5f), 0.5 * (0.25 + 0.4), 1e-5) << "also where it is narrow";
  EXPECT_EQ(height_at(0.6f, 1), 0);
  EXPECT_EQ(height_at(0.6f, -1), 0);
}

TEST_F(Tread, BeginsAndEndsWithStampsOfTheirOwn) {
  stroke_.params.set_file("start_stamp", "start");
  stroke_.params.set_file("end_stamp", "end");
  stroke_.params.set("fit", 1);  // four tiles of 2.5
  EXPECT_NEAR(height_at(1, 0), 10 + 0.4 + 2, 1e-5);
  EXPECT_NEAR(height_at(3.5f, 0), 0.4 + 2, 1e-5);
  EXPECT_NEAR(height_at(9, 0), 20 + 0.6 + 2, 1e-5);
  EXPECT_NEAR(height_at(-0.5f, 0), 10 + 2, 1e-5) << "the border of the start goes on";
  EXPECT_EQ(stroke_.plan.end_influence, std::numeric_limits<double>::infinity());
  stroke_.context.flags |= BURIN_STROKE_CLOSED;
  EXPECT_NEAR(height_at(1, 0), 0.4 + 2, 1e-5) << "a loop has no ends";
}

TEST_F(Tread, ShowsTheOtherStampInHalfOfItsTiles) {
  stroke_.params.set_file("other_stamp", "other");
  stroke_.context.length = 2.4 * 200;
  int other = 0;
  for (int tile = 0; tile < 200; ++tile) {
    const float height = height_at(2.4f * (static_cast<float>(tile) + 0.5f), 0);
    if (height > 30) ++other;
    EXPECT_NEAR(height, height > 30 ? 32.5 : 2.5, 1e-3);
  }
  EXPECT_NEAR(other, 100, 42);
}

TEST_F(Tread, NamesTheStampThatCannotBeOpened) {
  stroke_.params.set_file("end_stamp", "missing.exr");
  const test::Answer answer = stroke_.begin();
  EXPECT_EQ(answer.status, BURIN_NOT_FOUND);
  EXPECT_EQ(answer.text, "missing.exr: no such file");
  EXPECT_EQ(host_.open_stamps, 0);
}

}  // namespace
}  // namespace burin
