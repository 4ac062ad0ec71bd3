#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
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

TEST(Printable, LeavesTextAsItIs) {
  EXPECT_EQ(printable(""), "");
  EXPECT_EQ(printable("a b\\c"), "a b\\c");
  EXPECT_EQ(printable("H\xc3\xb6he \xf0\x9f\x96\x8b"), "H\xc3\xb6he \xf0\x9f\x96\x8b");
  EXPECT_EQ(printable(std::string(100000, 'x')), std::string(100000, 'x'));
}

TEST(Printable, ShowsWhatWouldReachTheTerminal) {
  EXPECT_EQ(printable("\x1b[2Jx\n\x7f"), "\\x1b[2Jx\\x0a\\x7f");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");           // a control beyond ASCII
  EXPECT_EQ(printable("\xe2\x80\xa8"), "\\xe2\\x80\\xa8");  // a line separator
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");           // no UTF-8
  EXPECT_EQ(printable("\xc0\x80"), "\\xc0\\x80");           // zero in two bytes
}

TEST(FileError, ShowsControlCharactersOfThePath) {
  EXPECT_STREQ(FileError("a\x1b[2J\n.obj", "3", "what").what(), "a\\x1b[2J\\x0a.obj:3: what");
}

}  // namespace
}  // namespace burin
