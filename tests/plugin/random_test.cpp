#include <burin/plugin/random.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>

namespace burin {
namespace {

using plugin::Random;

TEST(Random, IsSplitMix64) {
  // The first outputs for this seed, as published at rosettacode.org/wiki/Pseudo-random_numbers/Splitmix64.
  constexpr std::array<std::uint64_t, 5> published = {6457827717110365317u, 3203168211198807973u,
                                                      9817491932198370423u, 4593380528125082431u,
                                                      16408922859458223821u};
  for (std::uint64_t i = 0; i < published.size(); ++i)
    EXPECT_EQ(Random::splitmix64(1234567, i), published[i]);
}

TEST(Random, CountsWithinTheGeneratorOfAChannel) {
  static_assert(Random(7).bits(3, 2) == Random::splitmix64(Random::splitmix64(7, 2), 3));
  static_assert(Random(7).bits(3) == Random(7).bits(3, 0));
  static_assert(Random(7)(3) < 1);
}

TEST(Random, IsUniform) {
  constexpr std::size_t bins = 64, draws = 1 << 18;
  for (const bool by_channel : {false, true}) {
    const Random random(99);
    std::array<double, bins> counts{};
    for (std::uint64_t i = 0; i < draws; ++i) {
      const float x = by_channel ? random(5, i) : random(i, 5);
      ASSERT_GE(x, 0);
      ASSERT_LT(x, 1);
      ++counts[static_cast<std::size_t>(x * bins)];
    }
    double chi_squared = 0;
    const double expected = static_cast<double>(draws) / bins;
    for (const double count : counts) chi_squared += (count - expected) * (count - expected) / expected;
    EXPECT_LT(chi_squared, 103) << "of 63 degrees of freedom, less in 99.9 % of cases";
  }
}

TEST(Random, ChangesHalfTheBitsWithEveryBitOfItsName) {
  const std::uint64_t bits = Random(1).bits(2, 3);
  double flipped = 0;
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t one = std::uint64_t{1} << bit;
    flipped += std::popcount(bits ^ Random(1 ^ one).bits(2, 3));
    flipped += std::popcount(bits ^ Random(1).bits(2 ^ one, 3));
    flipped += std::popcount(bits ^ Random(1).bits(2, 3 ^ one));
  }
  EXPECT_NEAR(flipped / (3 * 64), 32, 1.2);
}

}  // namespace
}  // namespace burin
