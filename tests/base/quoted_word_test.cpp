#include <burin/base/quoted_word.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(QuotedWord, ShowsControlsAndBytesThatAreNoText) {
  EXPECT_EQ(quoted_word("0.5oo"), "'0.5oo'");
  EXPECT_EQ(quoted_word("\x1b[31m\n\xff\xc2\x85"), "'\\x1b[31m\\x0a\\xff\\xc2\\x85'");
  EXPECT_EQ(quoted_word("gr\xc3\xbc\xc3\x9f"), "'gr\xc3\xbc\xc3\x9f'");
  EXPECT_EQ(quoted_word(""), "''");
}

TEST(QuotedWord, CutsBetweenCharacters) {
  EXPECT_EQ(quoted_word(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
  EXPECT_EQ(quoted_word(std::string(41, 'a')), "'" + std::string(40, 'a') + "...'");
  EXPECT_EQ(quoted_word(std::string(39, 'a') + "\xc3\xbc"), "'" + std::string(39, 'a') + "...'");
}

}  // namespace
}  // namespace burin
