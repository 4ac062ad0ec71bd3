#include <burin/plugin/detail/param_values.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plugin/driver.h"

namespace burin {
namespace {

class ParamsProbe : public testing::Test {
 protected:
  test::PluginModule module_{"test-brushes/probes"};
  test::TestHost host_;
  test::StrokeDriver stroke_{module_, "org.burin.test.params", host_.abi};

  void evaluate() {
    stroke_.end();
    ASSERT_EQ(stroke_.begin().status, BURIN_OK);
    const test::Answer answer = stroke_.evaluate({{0.25f, 0.75f}, {0, 0}});
    ASSERT_EQ(answer.status, BURIN_OK) << answer.text;
  }
};

TEST_F(ParamsProbe, ReadsTheDefaultsOfItsDescriptor) {
  evaluate();
  EXPECT_EQ(stroke_.along, (std::vector<float>{3.5f, 3.5f})) << "0.5, and the length of abc";
  EXPECT_EQ(stroke_.across, (std::vector<float>{32, 32}));
  EXPECT_EQ(stroke_.up, (std::vector<float>{2, 1.5f}));
  EXPECT_EQ(stroke_.mask, (std::vector<float>{11, 11})) << "length of default.txt";
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(stroke_.colour[i], std::vector<float>(2, 0.1f * static_cast<float>(i + 1)));
}

TEST_F(ParamsProbe, ReadsWhatTheHostSets) {
  stroke_.params.set("number", {1, 9, 2, 9}, 2);
  stroke_.params.set("count", -16777216);
  stroke_.params.set("shape", 0);
  stroke_.params.set_file("file", "/a");
  stroke_.params.set_file("text", "");
  const float knots[] = {0, 0, 1, 4}, blue[] = {0.5f, 0.75f};
  stroke_.params.value("curve").knots = knots;
  stroke_.params.value("curve").knot_count = 2;
  stroke_.params.value("paint").colour[2] = {blue, 1, 0};
  evaluate();
  EXPECT_EQ(stroke_.along, (std::vector<float>{1, 2}));
  EXPECT_EQ(stroke_.across, (std::vector<float>{-167772160, -167772160}));
  EXPECT_EQ(stroke_.up, (std::vector<float>{1, 3}));
  EXPECT_EQ(stroke_.mask, (std::vector<float>{2, 2}));
  EXPECT_EQ(stroke_.colour[2], (std::vector<float>{0.5f, 0.75f}));
  stroke_.params.set("on", 0);
  evaluate();
  EXPECT_EQ(stroke_.mask[0], -1);
}

TEST_F(ParamsProbe, DescribesEachType) {
  const burin_brush_descriptor& brush = module_.descriptor("org.burin.test.params");
  const auto info = [&](std::uint32_t i) -> const burin_param_info& { return *brush.params[i]; };
  const burin_param_type types[] = {BURIN_PARAM_FLOAT,  BURIN_PARAM_INT,    BURIN_PARAM_BOOL,
                                    BURIN_PARAM_CHOICE, BURIN_PARAM_COLOUR, BURIN_PARAM_FILE,
                                    BURIN_PARAM_CURVE,  BURIN_PARAM_TEXT};
  ASSERT_EQ(brush.param_count, std::size(types));
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    EXPECT_EQ(info(i).struct_size, sizeof(burin_param_info));
    EXPECT_EQ(info(i).type, types[i]);
  }
  EXPECT_STREQ(info(0).help, "Any.");
  EXPECT_EQ(info(0).unit, BURIN_UNIT_ANGLE);
  EXPECT_EQ(info(0).hard_min, -100);
  EXPECT_EQ(info(0).hard_max, 100);
  EXPECT_EQ(info(0).soft_min, -1);
  EXPECT_EQ(info(0).soft_max, 1);
  EXPECT_EQ(info(0).default_number, 0.5f);
  EXPECT_EQ(info(0).dynamic, 1u);
  EXPECT_EQ(info(1).dynamic, 0u);
  EXPECT_STREQ(info(3).choices[2], "star");
  EXPECT_EQ(info(3).choices[3], nullptr);
  EXPECT_EQ(info(6).default_knot_count, 3u);
  EXPECT_STREQ(info(7).default_text, "abc");
}

TEST(Curve, RunsStraightBetweenKnotsAndLevelBeyond) {
  const float knots[] = {1, 10, 2, 20, 4, 0};
  const plugin::Curve curve(knots, 3);
  EXPECT_EQ(curve(-5), 10);
  EXPECT_EQ(curve(1), 10);
  EXPECT_EQ(curve(1.5f), 15);
  EXPECT_EQ(curve(2), 20);
  EXPECT_EQ(curve(3), 10);
  EXPECT_EQ(curve(4), 0);
  EXPECT_EQ(curve(std::numeric_limits<float>::infinity()), 0);
  EXPECT_EQ(curve(std::numeric_limits<float>::quiet_NaN()), 10);
  EXPECT_EQ(plugin::Curve(knots, 1)(7), 10);
}

TEST(Params, NameTheParameterThatIsNotListed) {
  const burin_brush_descriptor none{};
  static constexpr plugin::FloatParam depth{.id = "depth", .name = "Depth"};
  try {
    plugin::Params(none, nullptr)[depth];
    FAIL();
  } catch (const plugin::Error& error) {
    EXPECT_STREQ(error.what(), "no value for parameter 'depth': is it in the brush's param_list?");
  }
}

}  // namespace
}  // namespace burin
