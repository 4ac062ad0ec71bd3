#include "descriptors.h"

#include <burin/host/plugin/descriptor_check.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace burin {
namespace {

using test::Descriptor;
using test::param_of;

constexpr float infinity = std::numeric_limits<float>::infinity();

std::string problem(burin_param_type type, const std::function<void(burin_param_info&)>& change) {
  burin_param_info info = param_of(type, "depth");
  change(info);
  return param_problem(info);
}

TEST(DescriptorCheck, AcceptsWhatIsInOrder) {
  const Descriptor brush({param_of(BURIN_PARAM_FLOAT, "depth"), param_of(BURIN_PARAM_INT, "count"),
                          param_of(BURIN_PARAM_BOOL, "inverted"), param_of(BURIN_PARAM_CHOICE, "profile"),
                          param_of(BURIN_PARAM_COLOUR, "paint"), param_of(BURIN_PARAM_FILE, "stamp"),
                          param_of(BURIN_PARAM_CURVE, "response"), param_of(BURIN_PARAM_TEXT, "words")});
  EXPECT_EQ(descriptor_problem(brush.abi), "");
  EXPECT_EQ(problem(BURIN_PARAM_FLOAT,
                    [](auto& info) {
                      info.hard_min = -infinity;
                      info.hard_max = infinity;
                    }),
            "");
}

TEST(DescriptorCheck, FindsWhatIsWrongWithAParameter) {
  const float two_alike[] = {1, 0, 1, 2};
  const char* const twins[] = {"round", "round", nullptr};
  const char* const none[] = {nullptr};
  const struct {
    burin_param_type type;
    std::function<void(burin_param_info&)> change;
    const char* problem;
  } cases[] = {
      {BURIN_PARAM_FLOAT, [](auto& i) { i.default_number = 5; }, "its default 5 lies outside 0 .. 4"},
      {BURIN_PARAM_FLOAT, [](auto& i) { i.default_number = std::numeric_limits<float>::quiet_NaN(); },
       "its default is not finite"},
      {BURIN_PARAM_FLOAT, [](auto& i) { i.hard_min = 5; }, "its hard range is empty"},
      {BURIN_PARAM_FLOAT, [](auto& i) { i.soft_max = 5; },
       "its soft range 0 .. 5 exceeds the hard range 0 .. 4"},
      {BURIN_PARAM_FLOAT, [](auto& i) { i.soft_min = 3; }, "its soft range is empty"},
      {BURIN_PARAM_FLOAT, [](auto& i) { i.soft_max = infinity; }, "its soft range is not finite"},
      {BURIN_PARAM_INT, [](auto& i) { i.default_number = 1.5f; }, "1.5 is no whole number within 2^24"},
      {BURIN_PARAM_BOOL, [](auto& i) { i.default_number = 2; }, "its default is neither 0 nor 1"},
      {BURIN_PARAM_CHOICE, [](auto& i) { i.default_number = 2; }, "its default 2 is none of its 2 choices"},
      {BURIN_PARAM_CHOICE, [](auto& i) { i.choices = nullptr; }, "no choices"},
      {BURIN_PARAM_CHOICE, [&](auto& i) { i.choices = none; }, "no choices"},
      {BURIN_PARAM_CHOICE, [&](auto& i) { i.choices = twins; }, "two choices 'round'"},
      {BURIN_PARAM_COLOUR, [](auto& i) { i.default_colour[2] = -1; }, "its default has a channel of -1"},
      {BURIN_PARAM_CURVE, [](auto& i) { i.default_knot_count = 0; }, "a curve without knots"},
      {BURIN_PARAM_CURVE, [&](auto& i) { i.default_knots = two_alike; }, "knots whose x does not rise"},
      {BURIN_PARAM_TEXT, [](auto& i) { i.default_text = "a\nb"; }, "its default is no text"},
      {BURIN_PARAM_UNKNOWN, [](auto&) {}, "type 0 is unknown"},
      {BURIN_PARAM_FLOAT, [](auto& i) { i.name = ""; }, "no proper name"},
      {BURIN_PARAM_FLOAT, [](auto& i) { i.help = "a\nb"; }, "its help is no text"},
  };
  for (const auto& test_case : cases)
    EXPECT_EQ(problem(test_case.type, test_case.change),
              std::string("parameter 'depth': ") + test_case.problem);
  EXPECT_EQ(problem(BURIN_PARAM_FLOAT, [](auto& i) { i.id = "Depth"; }),
            "a parameter's id is not of a-z, 0-9 and _");
  EXPECT_EQ(problem(BURIN_PARAM_FLOAT, [](auto& i) { i.struct_size = 8; }),
            "a parameter's struct_size is too small");
}

TEST(DescriptorCheck, FindsWhatIsWrongWithABrush) {
  const struct {
    std::function<void(burin_brush_descriptor&)> change;
    const char* problem;
  } cases[] = {
      {[](auto& d) { d.struct_size = 16; }, "a brush descriptor's struct_size is too small"},
      {[](auto& d) { d.id = nullptr; }, "a brush's id is no reverse DNS name such as org.example.brush"},
      {[](auto& d) { d.id = "groove"; }, "a brush's id is no reverse DNS name such as org.example.brush"},
      {[](auto& d) { d.id = "org..groove"; },
       "a brush's id is no reverse DNS name such as org.example.brush"},
      {[](auto& d) { d.vendor = nullptr; }, "brush org.burin.test.brush: no proper vendor"},
      {[](auto& d) { d.features = nullptr; }, "brush org.burin.test.brush: no list of features"},
      {[](auto& d) { d.param_count = 2, d.params = nullptr; },
       "brush org.burin.test.brush: counts parameters but lists none"},
      {[](auto& d) { d.overlap = 7; }, "brush org.burin.test.brush: overlap 7 is none that there is"},
      {[](auto& d) { d.rim_slope = -1; }, "brush org.burin.test.brush: its rim slope is -1"},
      {[](auto& d) { d.overlap = -1; }, "brush org.burin.test.brush: overlap -1 is none that there is"},
  };
  for (const auto& test_case : cases) {
    Descriptor brush({});
    test_case.change(brush.abi);
    EXPECT_EQ(descriptor_problem(brush.abi), test_case.problem);
  }
  const Descriptor twins({param_of(BURIN_PARAM_FLOAT, "depth"), param_of(BURIN_PARAM_INT, "depth")});
  EXPECT_EQ(descriptor_problem(twins.abi), "brush org.burin.test.brush: two parameters 'depth'");
}

TEST(DescriptorCheck, KnowsTextFromBytes) {
  EXPECT_TRUE(is_text("Gravüre ✎ 𝒢"));
  for (const char* bytes :
       {"", "\xff", "\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\x80", "a\x1b[1m"})
    EXPECT_FALSE(is_text(bytes)) << bytes;
  EXPECT_FALSE(is_text(nullptr));
}

}  // namespace
}  // namespace burin
