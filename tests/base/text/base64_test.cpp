#include <burin/base/text/base64.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

// The examples of RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  const char* const words[][2] = {{"", ""},
                                  {"f", "Zg=="},
                                  {"fo", "Zm8="},
                                  {"foo", "Zm9v"},
                                  {"foob", "Zm9vYg=="},
                                  {"fooba", "Zm9vYmE="},
                                  {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : words) {
    EXPECT_EQ(base64(plain), coded);
    EXPECT_EQ(from_base64(coded), plain);
  }
  EXPECT_EQ(from_base64("Zm9vYg"), "foob");
}

TEST(Base64, HasAllBytes) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  EXPECT_EQ(from_base64(base64(bytes)), bytes);
}

TEST(Base64, RefusesOtherLetters) {
  EXPECT_FALSE(from_base64("Zm9v?"));
  EXPECT_FALSE(from_base64("Zm9v\nYg"));
}

}  // namespace
}  // namespace burin
