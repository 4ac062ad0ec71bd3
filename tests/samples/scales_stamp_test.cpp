#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

class ScalesStamp : public ::testing::Test {
 protected:
  float texel(std::size_t x, std::size_t y) const {
    const auto width = static_cast<std::size_t>(stamp.width), height = static_cast<std::size_t>(stamp.height);
    return stamp.texels[y % height * width + x % width];
  }

  const StampImage stamp = read_stamp(BURIN_SAMPLES "/stamps/scales.exr");
};

TEST_F(ScalesStamp, IsAScalarHeightFromZeroToOne) {
  EXPECT_EQ(stamp.channels, 1);
  EXPECT_EQ(stamp.width, 256);
  EXPECT_EQ(stamp.height, 256);
  EXPECT_EQ(stamp.minimum, 0);
  EXPECT_EQ(stamp.maximum, 1);
}

TEST_F(ScalesStamp, RepeatsExactlyInStaggeredRows) {
  for (std::size_t y = 0; y < 256; ++y)
    for (std::size_t x = 0; x < 256; ++x) {
      ASSERT_EQ(texel(x + 64, y), texel(x, y)) << x << ' ' << y;
      ASSERT_EQ(texel(x, y + 64), texel(x, y)) << x << ' ' << y;
      ASSERT_EQ(texel(x + 32, y + 32), texel(x, y)) << x << ' ' << y;
    }
}

TEST_F(ScalesStamp, IsSymmetricAcross) {
  for (std::size_t y = 0; y < 256; ++y)
    for (std::size_t x = 0; x < 256; ++x) ASSERT_NEAR(texel(x, 255 - y), texel(x, y), 1e-3) << x << ' ' << y;
}

TEST_F(ScalesStamp, RisesTowardsFreeEdgesAndDropsThere) {
  // Along the middle of a scale, the greatest step up is gentle and the greatest step down is an edge.
  float up = 0, down = 0;
  for (std::size_t x = 0; x < 256; ++x) {
    const float step = texel(x + 1, 0) - texel(x, 0);
    up = std::max(up, step);
    down = std::max(down, -step);
  }
  EXPECT_LT(up, .1f);
  EXPECT_GT(down, 2 * up);
}

}  // namespace
}  // namespace burin
