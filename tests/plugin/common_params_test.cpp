#include <burin/plugin/plugin.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace burin::plugin {
namespace {

TEST(CommonParams, HaveIdsOfTheirOwnAndTakeWhatABrushSaysOfThem) {
  const std::vector<FloatParam> all = {
      common::depth("h", {0, 1}, 0.25f),  common::height("h", {0, 1}, 0.25f), common::width("h", 0.25f),
      common::taper("h", 0.25f),          common::tile({0, 1}, 0.25f),        common::fade("h", 0.25f),
      common::amount("h", {0, 1}, 0.25f),
  };
  std::set<std::string> ids, names;
  for (const FloatParam& param : all) {
    ids.insert(param.id);
    names.insert(param.name);
    EXPECT_EQ(param.default_value, 0.25f) << param.id;
    EXPECT_LE(param.hard.low, param.default_value) << param.id;
    EXPECT_GE(param.hard.high, param.default_value) << param.id;
    if (std::string(param.id) != "tile") {
      EXPECT_STREQ(param.help, "h");
    }
  }
  EXPECT_EQ(ids, (std::set<std::string>{"depth", "height", "width", "taper", "tile", "fade", "amount"}));
  EXPECT_EQ(names.size(), all.size());
}

TEST(CommonParams, AreMeasuredInRadiiButForShares) {
  EXPECT_EQ(common::depth("", {}, 0).unit, BURIN_UNIT_RADIUS);
  EXPECT_EQ(common::height("", {}, 0).unit, BURIN_UNIT_RADIUS);
  EXPECT_EQ(common::width("", 1).unit, BURIN_UNIT_RADIUS);
  EXPECT_EQ(common::taper("", 1).unit, BURIN_UNIT_RADIUS);
  EXPECT_EQ(common::roundness("", 1).unit, BURIN_UNIT_NONE);
  EXPECT_EQ(common::fade("", 1).unit, BURIN_UNIT_NONE);
  EXPECT_EQ(common::amount("", {0, 1}, 1).unit, BURIN_UNIT_NONE);
}

TEST(CommonParams, AreDynamicWhereEveryNodeMayHaveItsOwnUnlessConstant) {
  EXPECT_TRUE(common::width("", 1).dynamic);
  EXPECT_FALSE(common::constant(common::width("", 1)).dynamic);
  EXPECT_FALSE(common::taper("", 1).dynamic) << "it says how far ends are felt, once for the stroke";
}

}  // namespace
}  // namespace burin::plugin
