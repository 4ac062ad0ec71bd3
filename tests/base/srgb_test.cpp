#include <burin/base/srgb.h>

#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(Srgb, GivesEveryByteBack) {
  for (int byte = 0; byte < 256; ++byte) EXPECT_EQ(to_srgb(from_srgb(static_cast<std::uint8_t>(byte))), byte);
}

TEST(Srgb, KnowsMiddleGrey) {
  EXPECT_NEAR(from_srgb(119), 0.1845f, 1e-4f);
  EXPECT_NEAR(from_srgb(5), 5 / 255.0f / 12.92f, 1e-7f);
  EXPECT_EQ(from_srgb(255), 1);
}

}  // namespace
}  // namespace burin
