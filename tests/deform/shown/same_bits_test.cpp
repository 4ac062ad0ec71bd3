#include <burin/deform/shown/same_bits.h>
#include <gtest/gtest.h>

#include <limits>

namespace burin {
namespace {

TEST(SameBits, TellsBothZerosApartAndTakesNanForItself) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(same_bits({1, 2, nan}, {1, 2, nan}));
  EXPECT_FALSE(same_bits({1, 2, 0.f}, {1, 2, -0.f}));
  EXPECT_FALSE(same_bits({0.f, 2, 3}, {-0.f, 2, 3}));
}

}  // namespace
}  // namespace burin
