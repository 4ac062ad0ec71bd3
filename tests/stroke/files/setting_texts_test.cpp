#include <burin/stroke/files/setting_texts.h>
#include <gtest/gtest.h>

#include "support/error_of.h"

namespace burin {
namespace {

using Texts = std::vector<std::string>;

bool is_text(const std::string& param) { return param == "stamp"; }

ReplaySettings settings_of(const Texts& texts) {
  GivenSettings given;
  read_setting_texts(texts, is_text, given);
  return given.complete();
}

std::string error_of(const Texts& texts) {
  return test::error_of([&] { settings_of(texts); });
}

TEST(SettingTexts, AreOfEveryForm) {
  const ReplaySettings settings =
      settings_of({"brush=org.burin.groove", "radius=0.25", "clamp=true", "symmetry_centre=1,2,-3.5",
                   "mirror=x", "join=miter", "show_every=3", "dynamics=strength=t:0,0,4,1",
                   "params=depth=-0.5", "dynamics=radius=pressure:0,1,1,2", "params=on=true",
                   "params=curve=0,1,1,0", "params=stamp=12", "params=word=a=b"});
  EXPECT_EQ(settings.brush, "org.burin.groove");
  EXPECT_EQ(settings.radius, 0.25);
  EXPECT_TRUE(settings.clamp_to_radius);
  EXPECT_EQ(settings.symmetry.centre, Vec3d(1, 2, -3.5));
  EXPECT_EQ(settings.join, Join::miter);
  EXPECT_EQ(settings.show_every, 3u);
  ASSERT_EQ(settings.dynamics.size(), 2u);
  EXPECT_EQ(settings.dynamics[1].target, "radius");
  const ParamSettings params = {{"depth", -0.5},
                                {"on", true},
                                {"curve", {0, 1, 1, 0}},
                                {"stamp", std::string("12")},
                                {"word", std::string("a=b")}};
  EXPECT_EQ(settings.params, params);
}

TEST(SettingTexts, AreRefusedByTheirNames) {
  EXPECT_EQ(error_of({"radios=1"}), "settings: there is no setting 'radios'");
  EXPECT_EQ(error_of({"radius"}), "settings: must be NAME=VALUE, not 'radius'");
  EXPECT_EQ(error_of({"=1"}), "settings: must be NAME=VALUE, not '=1'");
  EXPECT_EQ(error_of({"params=depth"}), "params: must be NAME=VALUE, not 'depth'");
  EXPECT_EQ(error_of({"radius=1", "radius=1"}), "radius: is given twice");
  EXPECT_EQ(error_of({"radius=0"}), "settings: radius: must be a number above 0, not 0");
  EXPECT_EQ(error_of({"clamp=1"}).find("settings: clamp: must be true or false"), 0u)
      << error_of({"clamp=1"});
  EXPECT_EQ(error_of({"dynamics=strength"}).find("dynamics: must be TARGET=SOURCE:X0,Y0,X1,Y1,..., not "),
            0u);
  EXPECT_EQ(error_of({"radial_axis=x"}), "settings: radial_axis: decides nothing without 'radial'");
}

TEST(SettingTexts, OfARecordingMakeItsSettingsAgain) {
  const Texts texts = {"brush=org.burin.groove",
                       "radius=0.1234567890123",
                       "strength=-2",
                       "params=depth=0.5",
                       "params=name=a=b",
                       "params=on=true",
                       "params=tints=0,0.25,1",
                       "dynamics=strength=pressure:0,0,1,1.5",
                       "dynamics=radius=t:0,1,2,0.5",
                       "follow=0.25",
                       "closed=auto"};
  GivenSettings given;
  read_setting_texts(texts, is_text, given);
  GivenSettings again;
  read_setting_texts(setting_texts(given), is_text, again);
  const ReplaySettings expected = given.complete(), settings = again.complete();
  EXPECT_EQ(settings.brush, expected.brush);
  EXPECT_EQ(settings.radius, 0.1234567890123);
  EXPECT_EQ(settings.strength, -2);
  EXPECT_EQ(settings.params, expected.params);
  ASSERT_EQ(settings.dynamics.size(), 2u);
  EXPECT_EQ(settings.dynamics[0].target, "strength");
  EXPECT_EQ(setting_texts(again), setting_texts(given));
  EXPECT_EQ(settings.follow, 0.25);
  EXPECT_EQ(settings.closure, Closure::automatic);
  EXPECT_EQ(setting_texts({}), Texts());
}

TEST(SettingTexts, OfEveryClosureMakeItAgain) {
  for (const char* text : {"closed=yes", "closed=no", "closed=auto"}) {
    GivenSettings given, again;
    read_setting_texts(Texts{text}, is_text, given);
    read_setting_texts(setting_texts(given), is_text, again);
    EXPECT_EQ(again.complete().closure, given.complete().closure) << text;
  }
}

}  // namespace
}  // namespace burin
