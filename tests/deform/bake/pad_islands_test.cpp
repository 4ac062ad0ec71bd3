#include <burin/base/parallel.h>
#include <burin/deform/bake/pad_islands.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

struct Islands {
  FloatImage image;
  std::vector<std::uint8_t> known;

  Islands(int width, int height, std::vector<std::string> channels)
      : image{width, height, std::move(channels), {}} {
    known.resize(static_cast<std::size_t>(width * height));
    image.texels.resize(known.size() * image.channels.size());
  }
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row * image.width + column); }
  void set(int column, int row, std::vector<float> values) {
    known[at(column, row)] = 1;
    std::ranges::copy(values,
                      image.texels.begin() + static_cast<std::ptrdiff_t>(values.size() * at(column, row)));
  }
};

TEST(PadIslands, ContinuesByThatManyTexels) {
  Islands islands(11, 9, {"R", "G", "B"});
  islands.set(4, 5, {1, -2, 3});
  pad_islands(islands.image, islands.known, 2);
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 11; ++column) {
      const bool reached = std::abs(column - 4) <= 2 && std::abs(row - 5) <= 2;
      const std::size_t texel = islands.at(column, row);
      EXPECT_EQ(islands.known[texel], reached ? 1 : 0);
      EXPECT_EQ(islands.image.texels[3 * texel], reached ? 1 : 0);
      EXPECT_EQ(islands.image.texels[3 * texel + 1], reached ? -2 : 0);
      EXPECT_EQ(islands.image.texels[3 * texel + 2], reached ? 3 : 0);
    }
}

TEST(PadIslands, TakesMeansOfTheRoundBefore) {
  Islands islands(6, 1, {"Y"});
  islands.set(0, 0, {4});
  islands.set(5, 0, {8});
  islands.set(2, 0, {0});
  pad_islands(islands.image, islands.known, 1);
  EXPECT_EQ(islands.image.texels, (std::vector<float>{4, 2, 0, 0, 8, 8}));
  EXPECT_EQ(islands.known, (std::vector<std::uint8_t>(6, 1)));
}

TEST(PadIslands, ContinuesSlopesByOneTexel) {
  Islands islands(12, 12, {"Y"});
  const auto slope = [](int column, int row) { return static_cast<float>(3 * column - 2 * row); };
  for (int row = 4; row < 8; ++row)
    for (int column = 4; column < 8; ++column) islands.set(column, row, {slope(column, row)});
  pad_islands(islands.image, islands.known, 2);
  for (int row = 3; row < 9; ++row)
    for (int column = 3; column < 9; ++column)
      EXPECT_EQ(islands.image.texels[islands.at(column, row)], slope(column, row)) << column << " " << row;
  EXPECT_EQ(islands.image.texels[islands.at(2, 5)], slope(3, 5));
}

TEST(PadIslands, LeavesAnImageWithoutIslandsOrPaddingAlone) {
  Islands islands(5, 40, {"Y"});
  pad_islands(islands.image, islands.known, 8);
  EXPECT_EQ(std::ranges::count(islands.image.texels, 0.0F), 200);
  islands.set(2, 2, {1});
  pad_islands(islands.image, islands.known, 0);
  EXPECT_EQ(std::ranges::count(islands.image.texels, 0.0F), 199);
}

TEST(PadIslands, IsTheSameOnAnyNumberOfThreads) {
  const auto padded = [] {
    Islands islands(200, 150, {"Y"});
    for (int i = 0; i < 400; ++i) islands.set(i * 37 % 200, i * 71 % 150, {std::sin(static_cast<float>(i))});
    pad_islands(islands.image, islands.known, 8);
    return islands.image.texels;
  };
  const std::vector<float> expected = padded();
  for (const std::size_t threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(padded(), expected);
  }
}

}  // namespace
}  // namespace burin
