#include <burin/plugin/detail/param_list.h>
#include <burin/plugin/entry/checks.h>
#include <gtest/gtest.h>

#include <limits>

namespace burin::plugin {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(ReverseDns, IsPartsBetweenDots) {
  EXPECT_TRUE(checks::reverse_dns("org.burin.groove"));
  EXPECT_TRUE(checks::reverse_dns("com.Some-One.brush_2"));
  for (const char* id :
       {static_cast<const char*>(nullptr), "", "groove", ".org.x", "org.x.", "org..x", "org.x y"})
    EXPECT_FALSE(checks::reverse_dns(id)) << (id ? id : "null");
}

TEST(BudgetChecks, WantAFiniteNumberFromZeroOn) {
  EXPECT_TRUE(checks::promises(0));
  EXPECT_TRUE(checks::promises(40.5));
  for (const double budget :
       {-1.0, -0.5, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(checks::promises(budget)) << budget;
}

bool accepted(const auto& param) { return !checks::broken_by(param_list(param), 0); }

TEST(ParamChecks, WantIdAndName) {
  EXPECT_TRUE(accepted(FloatParam{.id = "a_1", .name = "A"}));
  EXPECT_FALSE(accepted(FloatParam{.name = "A"}));
  EXPECT_FALSE(accepted(FloatParam{.id = "a"}));
  EXPECT_FALSE(accepted(FloatParam{.id = "A", .name = "A"}));
  EXPECT_FALSE(accepted(FileParam{.id = "a b", .name = "A"}));
}

TEST(ParamChecks, NameTheRule) {
  const auto rule = [](const auto& param) { return checks::broken_by(param_list(param), 0); };
  EXPECT_STREQ(rule(FloatParam{.id = "A", .name = "A"}), "its id is not of a-z, 0-9 and _");
  EXPECT_STREQ(rule(FloatParam{.id = "a", .name = "A", .hard = {0, 2}, .default_value = 3}),
               "its default is not within the hard range");
  EXPECT_STREQ(rule(FloatParam{.id = "a", .name = "A", .hard = {0, 2}, .soft = {1, 3}}),
               "its soft range is not within the hard range");
  EXPECT_STREQ(rule(IntParam{.id = "a", .name = "A", .hard = {0, 1.5f}}),
               "an end of its ranges is no whole number within +-2^24");
  EXPECT_STREQ(rule(ChoiceParam{.id = "a", .name = "A", .choices = {"x", "x"}}),
               "two of its choices are equal");
}

TEST(ParamChecks, WantEachIdOnce) {
  const FloatParam a{.id = "a", .name = "A"}, b{.id = "b", .name = "A"};
  const IntParam another{.id = "a", .name = "Another"};
  EXPECT_EQ(checks::broken_by(param_list(a, b), 1), nullptr);
  EXPECT_STREQ(checks::broken_by(param_list(a, b, another), 2), "its id is that of another parameter");
}

TEST(ParamChecks, WantTheDefaultInTheHardRangeAndTheSoftOneWithin) {
  const auto number = [](Range hard, Range soft, float initial) {
    return accepted(FloatParam{.id = "a", .name = "A", .hard = hard, .soft = soft, .default_value = initial});
  };
  EXPECT_TRUE(number({0, 2}, {0, 1}, 1.5f));
  EXPECT_TRUE(number({-infinity, infinity}, {0, 1}, 5));
  EXPECT_FALSE(number({0, 2}, {0, 1}, 2.5f));
  EXPECT_FALSE(number({0, 2}, {-1, 1}, 0));
  EXPECT_FALSE(number({0, 2}, {1, 3}, 0));
  EXPECT_FALSE(number({0, 2}, {1, 0.5f}, 0));
  EXPECT_FALSE(number({2, 0}, {}, 1));
  EXPECT_FALSE(number({0, infinity}, {}, 1)) << "a slider of infinite length";
  EXPECT_FALSE(number({0, infinity}, {0, 1}, infinity));
  EXPECT_FALSE(number({0, std::numeric_limits<float>::quiet_NaN()}, {}, 0));
}

TEST(ParamChecks, WantWholeNumbersThatAFloatHolds) {
  EXPECT_TRUE(accepted(IntParam{.id = "a", .name = "A", .hard = {-16777216, 16777216}}));
  EXPECT_FALSE(accepted(IntParam{.id = "a", .name = "A", .hard = {0, 33554432}}));
  EXPECT_FALSE(accepted(IntParam{.id = "a", .name = "A", .hard = {0, 8}, .soft = {0, 1.5f}}));
}

TEST(ParamChecks, WantAChoiceThatExists) {
  EXPECT_TRUE(accepted(ChoiceParam{.id = "a", .name = "A", .choices = {"x", "y"}, .default_value = 1}));
  EXPECT_FALSE(accepted(ChoiceParam{.id = "a", .name = "A", .choices = {"x", "y"}, .default_value = 2}));
  EXPECT_FALSE(accepted(ChoiceParam{.id = "a", .name = "A"}));
  EXPECT_FALSE(accepted(ChoiceParam{.id = "a", .name = "A", .choices = {"x", "y", "x"}}));
}

TEST(ParamChecks, WantColoursOfShares) {
  EXPECT_TRUE(accepted(ColourParam{.id = "a", .name = "A", .default_value = {0, 1, 0.5f, 1}}));
  EXPECT_FALSE(accepted(ColourParam{.id = "a", .name = "A", .default_value = {0, 1, 0.5f, 1.5f}}));
}

TEST(ParamChecks, WantKnotsThatRise) {
  const auto curve = [](std::span<const float> knots) {
    return accepted(CurveParam{.id = "a", .name = "A", .default_value = knots});
  };
  const float rising[] = {0, 5, 1, 2}, level[] = {1, 5, 1, 2}, endless[] = {1, 5, 2, infinity};
  EXPECT_TRUE(curve(rising));
  EXPECT_FALSE(curve(level));
  EXPECT_FALSE(curve(endless));
  EXPECT_FALSE(curve({}));
}

TEST(AllDiffer, FindsTheSameTextAtAnotherAddress) {
  const std::string a = "a.b";
  EXPECT_TRUE(checks::all_differ({"a.b", "a.c"}));
  EXPECT_FALSE(checks::all_differ({"a.b", "a.c", a}));
}

}  // namespace
}  // namespace burin::plugin
