#include <burin/stamp/clean.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

StampImage image(int width, int height, std::vector<float> texels, Wrap wrap) {
  return {width, height, 1, std::move(texels), 0, 0, wrap, wrap};
}

TEST(FillNotFinite, TakesTheMeanOfTheFiniteNeighbours) {
  StampImage hole = image(3, 3, {1, 2, 3, 4, nan, 6, 7, 8, inf}, Wrap::black);
  EXPECT_EQ(fill_not_finite(hole), 2u);
  EXPECT_EQ(hole.texels, (std::vector<float>{1, 2, 3, 4, 31 / 7.0f, 6, 7, 8, 7}));
}

TEST(FillNotFinite, LooksAcrossTheBorderOnlyWhereTheImageGoesOn) {
  const std::vector<float> row = {-inf, 2, 3, 8};
  StampImage periodic = image(4, 1, row, Wrap::periodic), black = image(4, 1, row, Wrap::black);
  fill_not_finite(periodic);
  fill_not_finite(black);
  EXPECT_EQ(periodic.texels[0], 5);
  EXPECT_EQ(black.texels[0], 2);
}

TEST(FillNotFinite, FillsWideHolesFromTheirRim) {
  StampImage hole = image(7, 1, {1, nan, nan, nan, nan, nan, 5}, Wrap::black);
  EXPECT_EQ(fill_not_finite(hole), 5u);
  EXPECT_EQ(hole.texels, (std::vector<float>{1, 1, 1, 3, 5, 5, 5}));
}

TEST(FillNotFinite, KeepsChannelsApart) {
  StampImage two{2, 1, 3, {nan, 20, 7, 1, nan, nan}, 0, 0, Wrap::black, Wrap::black};
  EXPECT_EQ(fill_not_finite(two), 3u);
  EXPECT_EQ(two.texels, (std::vector<float>{1, 20, 7, 1, 20, 7}));
}

TEST(FillNotFinite, MakesAChannelWithoutFiniteValuesZero) {
  StampImage none = image(2, 2, {nan, inf, -inf, nan}, Wrap::periodic);
  EXPECT_EQ(fill_not_finite(none), 4u);
  EXPECT_EQ(none.texels, std::vector<float>(4, 0));
}

TEST(FillNotFinite, LeavesAFiniteImageAlone) {
  StampImage whole = image(2, 2, {1, 2, 3, 4}, Wrap::periodic);
  EXPECT_EQ(fill_not_finite(whole), 0u);
  EXPECT_EQ(whole.texels, (std::vector<float>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace burin
