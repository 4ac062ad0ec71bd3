#include <burin/stroke/given_settings.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(GivenSettings, LeaveTheRestAsItIs) {
  GivenSettings given;
  given[&StrokeSettings::radius] = 0.25;
  given[&ReplaySettings::closure] = Closure::automatic;
  ReplaySettings settings;
  settings.radius = 1;
  settings.strength = 3;
  given.apply_to(settings);
  EXPECT_EQ(settings.radius, 0.25);
  EXPECT_EQ(settings.strength, 3);
  EXPECT_EQ(settings.closure, Closure::automatic);
  EXPECT_EQ(given.complete().strength, 1) << "the default";
}

TEST(GivenSettings, TellWhatIsGivenAlsoWhenItIsTheDefault) {
  GivenSettings given;
  EXPECT_EQ(given.find(&StrokeSettings::strength), nullptr);
  given[&StrokeSettings::strength] = 1;
  ASSERT_NE(given.find(&StrokeSettings::strength), nullptr);
  EXPECT_EQ(*given.find(&StrokeSettings::strength), 1);
  EXPECT_EQ(given.find(&StrokeSettings::radius), nullptr) << "of the same type";
  ReplaySettings settings;
  settings.strength = 3;
  given.apply_to(settings);
  EXPECT_EQ(settings.strength, 1);
}

TEST(GivenSettings, MayBeLeftOpenAgain) {
  GivenSettings given;
  given[&StrokeSettings::brush] = "a";
  given.erase(&StrokeSettings::brush);
  EXPECT_EQ(given.find(&StrokeSettings::brush), nullptr);
  EXPECT_EQ(given[&StrokeSettings::brush], "");
}

TEST(GivenSettings, AreCopiedWhole) {
  GivenSettings given;
  given[&StrokeSettings::params]["depth"] = 0.5;
  GivenSettings copy = given;
  copy[&StrokeSettings::params]["width"] = 2;
  EXPECT_EQ(given.complete().params, (ParamSettings{{"depth", 0.5}}));
  EXPECT_EQ(copy.complete().params, (ParamSettings{{"depth", 0.5}, {"width", 2}}));
}

}  // namespace
}  // namespace burin
