#include <burin/base/counting_sort.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace burin {
namespace {

constexpr unsigned seed = 19540601;

TEST(CountingSort, ListsTheItemsOfEveryBucketInOrderOnAnyNumberOfThreads) {
  std::mt19937 random(seed);
  constexpr std::size_t items = 5000, buckets = 300;
  std::vector<std::vector<std::size_t>> keys(items);
  std::vector<std::vector<std::size_t>> expected(buckets);
  for (std::size_t i = 0; i < items; ++i)
    for (std::size_t n = random() % 4; n > 0; --n) {
      keys[i].push_back(random() % (buckets - 1) + 1);  // nothing in the first bucket
      expected[keys[i].back()].push_back(i);
    }
  for (const std::size_t threads : {1U, 2U, 3U, 7U}) {
    const ThreadLimit limit(threads);
    std::vector<std::size_t> sorted(3 * items, items);
    const std::vector<Index> offsets = counting_sort(
        items, buckets, [&](std::size_t i, const auto& emit) { std::ranges::for_each(keys[i], emit); },
        [&](std::size_t i, std::size_t position) { sorted[position] = i; });
    ASSERT_EQ(offsets.size(), buckets + 1);
    for (std::size_t bucket = 0; bucket < buckets; ++bucket)
      ASSERT_EQ(
          std::vector<std::size_t>(sorted.begin() + offsets[bucket], sorted.begin() + offsets[bucket + 1]),
          expected[bucket])
          << "seed " << seed << ", threads " << threads;
  }
}

TEST(CountingSort, OfNothingHasEmptyBuckets) {
  const auto never = [](auto&&...) { FAIL(); };
  EXPECT_EQ(counting_sort(0, 3, never, never), std::vector<Index>(4, 0));
}

TEST(RadixSort, SortsByTheseBitsAndLeavesEqualOnesInOrder) {
  std::mt19937_64 random(seed);
  for (const auto& [first_bit, end_bit] : {std::pair{0, 64}, {5, 43}, {7, 8}, {20, 64}}) {
    UnsetVector<std::uint64_t> keys(4000);
    std::ranges::generate(keys, random);
    UnsetVector<std::uint64_t> expected = keys;
    const auto bits = [first = first_bit, end = end_bit](std::uint64_t key) {
      return key << (64 - end) >> (64 - end + first);
    };
    std::ranges::stable_sort(expected, {}, bits);
    radix_sort(keys, first_bit, end_bit);
    EXPECT_EQ(keys, expected) << first_bit << " to " << end_bit;
  }
}

}  // namespace
}  // namespace burin
