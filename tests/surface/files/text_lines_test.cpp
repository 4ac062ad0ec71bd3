#include <burin/surface/files/text_lines.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Lines = std::vector<std::pair<std::size_t, std::string>>;

Lines lines_of(std::string_view text) {
  Lines lines;
  TextLines reader(text);
  while (const auto line = reader.next()) lines.emplace_back(reader.number(), *line);
  return lines;
}

Lines joined_lines_of(std::string_view text) {
  Lines lines;
  TextLines reader(text);
  while (const auto line = reader.next_joined()) lines.emplace_back(reader.number(), *line);
  return lines;
}

TEST(TextLines, EndInCrOrLfOrBoth) {
  EXPECT_EQ(lines_of("a\rb\nc\r\nd\n\re"),
            (Lines{{1, "a"}, {2, "b"}, {3, "c"}, {4, "d"}, {5, ""}, {6, "e"}}));
  EXPECT_EQ(lines_of("a\n"), (Lines{{1, "a"}}));
  EXPECT_EQ(lines_of("\xef\xbb\xbfv 1"), (Lines{{1, "v 1"}}));
  EXPECT_TRUE(lines_of("").empty());
  EXPECT_TRUE(lines_of("\xef\xbb\xbf").empty());
}

TEST(TextLines, AreJoinedWhereABackslashStandsAtTheEnd) {
  EXPECT_EQ(joined_lines_of("a \\\r\n b\\ \r\\\rc\nd"), (Lines{{1, "a   b  c"}, {5, "d"}}));
  EXPECT_EQ(joined_lines_of("a # C:\\\nb"), (Lines{{1, "a"}, {2, "b"}}));
  EXPECT_EQ(joined_lines_of("0 -1.#IND # 1\n1.#comment"), (Lines{{1, "0 -1.#IND"}, {2, "1."}}));
  EXPECT_EQ(joined_lines_of("#\n\na\\"), (Lines{{1, ""}, {2, ""}, {3, "a "}}));
}

TEST(NextWord, StandsBetweenBlanks) {
  std::string_view line = "\t one  two\v";
  EXPECT_EQ(next_word(line), "one");
  EXPECT_EQ(next_word(line), "two");
  EXPECT_EQ(next_word(line), "");
}

TEST(Numbers, AreWholeWords) {
  EXPECT_EQ(real_number("+1e-3"), 1e-3);
  EXPECT_EQ(real_number("-1e999"), -INFINITY);
  EXPECT_EQ(real_number("1e-999"), 0);
  for (const char* word : {"", "+", "+-1", "1,5", "0.5oo", "1x"}) {
    EXPECT_FALSE(real_number(word)) << word;
    EXPECT_FALSE(whole_number(word)) << word;
  }
  EXPECT_TRUE(std::isnan(*real_number("-1.#IND00")));
  EXPECT_TRUE(std::isnan(*real_number("1.#QNAN")));
  EXPECT_EQ(real_number("-1.#INF"), -INFINITY);
  EXPECT_FALSE(real_number("1.#IN"));
  EXPECT_EQ(whole_number("+7"), 7);
  EXPECT_FALSE(whole_number("1.5"));
}

}  // namespace
}  // namespace burin
