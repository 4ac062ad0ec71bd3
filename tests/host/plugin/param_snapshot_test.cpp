#include "descriptors.h"
#include "support/error_of.h"

#include <burin/abi/plugin.h>
#include <burin/host/plugin/param_snapshot.h>
#include <gtest/gtest.h>

#include <limits>

namespace burin {
namespace {

using test::Descriptor;
using test::param_of;

std::vector<burin_param_info> one_of_each() {
  burin_param_info file = param_of(BURIN_PARAM_FILE, "stamp");
  file.default_file = "default.exr";
  return {param_of(BURIN_PARAM_FLOAT, "depth"),    param_of(BURIN_PARAM_INT, "count"),
          param_of(BURIN_PARAM_BOOL, "inverted"),  param_of(BURIN_PARAM_CHOICE, "profile"),
          param_of(BURIN_PARAM_COLOUR, "paint"),   file,
          param_of(BURIN_PARAM_CURVE, "response"), param_of(BURIN_PARAM_TEXT, "words")};
}

std::string failure(const burin_brush_descriptor& brush, const ParamSettings& settings) {
  return test::error_of([&] { ParamSnapshot(brush, settings); });
}

TEST(ParamSnapshot, HoldsDefaultsInTheOrderOfTheDescriptor) {
  const Descriptor brush(one_of_each());
  const ParamSnapshot snapshot(brush.abi, {});
  const burin_params& params = snapshot.abi();
  ASSERT_EQ(params.count, 8u);
  for (const int number : {0, 1, 2, 3}) {
    EXPECT_EQ(*params.values[number].number.data, 1.0f);
    EXPECT_EQ(params.values[number].number.stride, 0u);
  }
  EXPECT_EQ(*params.values[4].colour[3].data, 0.0f);
  EXPECT_STREQ(params.values[5].text, "default.exr");
  ASSERT_EQ(params.values[6].knot_count, 2u);
  EXPECT_EQ(params.values[6].knots[3], 3.0f);
  EXPECT_STREQ(params.values[7].text, "a line");
}

TEST(ParamSnapshot, TakesWhatIsSet) {
  const Descriptor brush(one_of_each());
  const ParamSnapshot snapshot(brush.abi, {{"depth", 2.5},
                                           {"count", 3.0},
                                           {"inverted", false},
                                           {"profile", std::string("v")},
                                           {"paint", std::vector<double>{0.1, 0.2, 0.3, 1}},
                                           {"stamp", std::string("rock.exr")},
                                           {"response", std::vector<double>{0, 0, 1, 1, 2, 5}},
                                           {"words", std::string()}});
  const burin_param_value* values = snapshot.abi().values;
  EXPECT_EQ(*values[0].number.data, 2.5f);
  EXPECT_EQ(*values[1].number.data, 3.0f);
  EXPECT_EQ(*values[2].number.data, 0.0f);
  EXPECT_EQ(*values[3].number.data, 1.0f);
  EXPECT_EQ(*values[4].colour[1].data, 0.2f);
  EXPECT_STREQ(values[5].text, "rock.exr");
  EXPECT_EQ(values[6].knot_count, 3u);
  EXPECT_EQ(values[6].knots[5], 5.0f);
  EXPECT_STREQ(values[7].text, "");
}

TEST(ParamSnapshot, SaysWhatIsWrongWithASetting) {
  const Descriptor brush(one_of_each());
  const struct {
    const char* id;
    ParamSetting setting;
    const char* message;
  } cases[] = {
      {"depth", 7.0, "7 is above the maximum 4"},
      {"depth", -0.5, "-0.5 is below the minimum 0"},
      {"depth", std::numeric_limits<double>::quiet_NaN(), "nan is out of range"},
      {"depth", 1e300, "1e+300 is out of range"},
      {"depth", std::string("deep"), "must be a number"},
      {"count", 1.5, "1.5 is no whole number within 2^24"},
      {"count", 5.0, "5 is above the maximum 4"},
      {"inverted", 2.0, "must be true or false"},
      {"profile", std::string("flat"), "no choice 'flat'; there are: round, v"},
      {"profile", 1.0, "must be the name of a choice"},
      {"paint", std::vector<double>{1, 1, 1}, "must be four numbers, red green blue alpha"},
      {"paint", std::vector<double>{1, 1, 1, 2}, "2 is not in 0 .. 1"},
      {"stamp", std::string(), "must be the path of a file"},
      {"response", std::vector<double>{0, 0, 0, 1}, "x = 0 does not rise"},
      {"response", std::vector<double>{0, 0, 1}, "must be pairs of numbers x y"},
  };
  for (const auto& [id, setting, message] : cases)
    EXPECT_EQ(failure(brush.abi, {{id, setting}}),
              std::string("parameter '") + id + "' of org.burin.test.brush: " + message);
}

TEST(ParamSnapshot, NamesTheParametersThereAre) {
  EXPECT_EQ(
      failure(Descriptor({param_of(BURIN_PARAM_FLOAT, "depth"), param_of(BURIN_PARAM_INT, "count")}).abi,
              {{"deepness", 1.0}}),
      "org.burin.test.brush has no parameter 'deepness'; there are: depth, count");
  EXPECT_EQ(failure(Descriptor({}).abi, {{"depth", 1.0}}),
            "org.burin.test.brush has no parameter 'depth'; there are: none");
}

TEST(ParamSnapshot, NeedsAFileThatHasNoDefault) {
  const Descriptor brush({param_of(BURIN_PARAM_FILE, "stamp")});
  EXPECT_EQ(failure(brush.abi, {}), "parameter 'stamp' of org.burin.test.brush: a file must be given");
}

}  // namespace
}  // namespace burin
