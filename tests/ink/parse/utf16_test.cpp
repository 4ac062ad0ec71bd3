#include <burin/ink/parse/utf16.h>

#include "ink/pen_files.h"

namespace burin {
namespace {

/// A text of UTF-16 with its mark.
std::string utf16(std::u16string_view text, bool little) {
  std::string bytes;
  const auto add = [&](char16_t unit) {
    const char low = static_cast<char>(unit & 0xFF), high = static_cast<char>(unit >> 8);
    bytes += little ? low : high;
    bytes += little ? high : low;
  };
  add(0xFEFF);
  for (const char16_t unit : text) add(unit);
  return bytes;
}

TEST(FromUtf16, MakesUtf8OfBothOrders) {
  for (const bool little : {false, true})
    EXPECT_EQ(from_utf16(utf16(u"a\u00e9\u20ac\U0001F58A", little)), "a\u00e9\u20ac\U0001F58A");
  EXPECT_EQ(from_utf16("a"), std::nullopt);
  EXPECT_EQ(from_utf16("\xff\xfe"), "");
}

TEST(FromUtf16, ReplacesWhatIsNoCharacter) {
  const std::u16string halves = {0xD83D, u'a', 0xDD8A, 0xD83D};
  EXPECT_EQ(from_utf16(utf16(halves, true)), "\uFFFDa\uFFFD\uFFFD");
  EXPECT_EQ(from_utf16(utf16(u"ab", true).substr(0, 5)), "a") << "half a unit at the end";
}

TEST(PenFilesInUtf16, AreReadAsOthersAre) {
  const test::PenFileFolder folder;
  for (const bool little : {false, true}) {
    EXPECT_EQ(test::places(folder.read(utf16(u"x\ty\r\n1\t2\r\n", little)).strokes.at(0)), "1 2");
    EXPECT_EQ(test::places(folder
                               .read(utf16(u"<?xml version=\"1.0\" encoding=\"UTF-16\"?><ink><trace>1 2, 3 4"
                                           u"</trace></ink>",
                                           little))
                               .strokes.at(0)),
              "1 2, 3 4");
  }
}

}  // namespace
}  // namespace burin
