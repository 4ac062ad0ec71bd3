#include <burin/base/text/utf8.h>
#include <gtest/gtest.h>

#include <string>

namespace burin {
namespace {

std::optional<std::u32string> decoded(std::string_view text) {
  std::u32string codes;
  while (!text.empty()) {
    const auto code = pop_code_point(text);
    if (!code) return std::nullopt;
    codes.push_back(*code);
  }
  return codes;
}

TEST(Utf8, IsRead) {
  EXPECT_EQ(decoded("A\u00e9\u20ac\U0001f600"), U"A\u00e9\u20ac\U0001f600");
  EXPECT_EQ(decoded("\xf4\x8f\xbf\xbf"), std::u32string{0x10ffff});
  EXPECT_EQ(decoded(std::string_view("\0z", 2)), (std::u32string{0, 'z'}));
}

TEST(Utf8, IsRefusedWhereItIsNone) {
  for (const char* text : {"\x80", "\xff", "\xc3", "\xc3(", "\xe2\x82", "\xc0\x80", "\xe0\x80\x80",
                           "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80"})
    EXPECT_TRUE(!decoded(text) && !is_utf8("A" + std::string(text))) << text;
  EXPECT_TRUE(is_utf8("A\u20ac") && is_utf8(""));
}

TEST(Utf8, KnowsControls) {
  for (const char32_t code : U"\n\t\x1f\x7f\x85\u2028\u2029") EXPECT_TRUE(is_control(code)) << int(code);
  for (const char32_t code : {U' ', U'~', U'\u00a0', U'\u00e9', U'\u2027'}) EXPECT_FALSE(is_control(code));
}

}  // namespace
}  // namespace burin
