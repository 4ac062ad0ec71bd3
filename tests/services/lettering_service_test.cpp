#include <burin/host/plugin/services.h>
#include <burin/plugin/lettering.h>
#include <burin/services/stamp_services.h>
#include <burin/stamp/lettering/font_search.h>
#include <gtest/gtest.h>

#include <string>

namespace burin {
namespace {

/// The error message for a lettering that the host refuses to set; "set" if it accepts it.
std::string complaint(const char* font, const char* text, std::uint32_t em = 32) {
  const HostServices services(nullptr, stamp_services());
  try {
    plugin::Lettering(plugin::Host(services.abi()), font, text, em);
  } catch (const plugin::Error& error) {
    return error.what();
  }
  return "set";
}

float sample(const plugin::Lettering& lettering, float x, float y) {
  float value = -1;
  lettering.stamp().sample(1,
                           [&](std::size_t) {
                             return plugin::StampArea{lettering.point_at(x, y), {}, {}};
                           },
                           {&value, 1});
  return value;
}

// Through the classes that brushes use.
TEST(LetteringService, SetsALineThatIsSampledInEms) {
  const HostServices services(nullptr, stamp_services());
  const plugin::Lettering line(plugin::Host(services.abi()), "DejaVuSans.ttf", "HI", 64);
  EXPECT_NEAR(line.info().width, (1540 + 604) / 2048.0, 1e-6);
  EXPECT_NEAR(line.info().ascent, 1901 / 2048.0, 1e-6);
  EXPECT_NEAR(line.info().descent, 483 / 2048.0, 1e-6);
  // The H has stems from 201 to 403 and from 1137 to 1339 of 2048 and its bar from 764 to 934, 1493 high.
  EXPECT_EQ(sample(line, 300 / 2048.0f, 0.1f), 1);
  EXPECT_EQ(sample(line, 1240 / 2048.0f, 0.7f), 1);
  EXPECT_EQ(sample(line, 770 / 2048.0f, 0.1f), 0);
  EXPECT_GT(sample(line, 770 / 2048.0f, 850 / 2048.0f), 0.9f);
  EXPECT_EQ(sample(line, 300 / 2048.0f, 1600 / 2048.0f), 0);
  EXPECT_EQ(sample(line, 300 / 2048.0f, -0.1f), 0);
  EXPECT_EQ(sample(line, -5, 3), 0);
}

TEST(LetteringService, SaysWhatIsWrong) {
  EXPECT_EQ(complaint("DejaVuSans.ttf", "abc"), "set");
  EXPECT_EQ(complaint("DejaVuSans.ttf", ""), "there is no text to set");
  EXPECT_NE(complaint("NoSuchFont.ttf", "abc").find("NoSuchFont.ttf: there is no such font"),
            std::string::npos);
  EXPECT_NE(complaint("NoSuchFont.ttf", "abc").find(system_font_folders().back().string()),
            std::string::npos);
  EXPECT_EQ(complaint("/no/such/font.ttf", "abc"), "/no/such/font.ttf: there is no such font file");
  EXPECT_NE(complaint("DejaVuSans.ttf", "abc", 4), "set");
  EXPECT_NE(complaint("DejaVuSans.ttf", "abc", 1000), "set");
}

}  // namespace
}  // namespace burin
