#include <burin/base/rising_threshold.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace burin {
namespace {

// Values change and come, thresholds rise, and fall now and then.
TEST(RisingThreshold, FindsAllFromTheThresholdOnEachOnce) {
  constexpr unsigned seed = 4;
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  RisingThreshold tail(0.5);
  std::vector<double> values;
  double threshold = 0;
  std::size_t found_most = 0, falls = 0;
  for (int event = 0; event < 300; ++event) {
    // By less than the slack, which adds up, or by more.
    const bool falls_now = random() % 6 == 0;
    threshold += !falls_now ? 0.1 : random() % 3 == 0 ? -3. : -0.3;
    falls += falls_now;
    std::vector<Index> changed;
    for (int i = 0; i < 20; ++i) {
      const auto slot = static_cast<Index>(random() % (values.size() + 5));
      for (auto added = static_cast<Index>(values.size()); added < slot; ++added) changed.push_back(added);
      if (slot >= values.size()) values.resize(slot + 1, std::numeric_limits<double>::quiet_NaN());
      values[slot] = random() % 8 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                       : threshold + static_cast<double>(random() % 100) / 25 - 2;
      changed.push_back(slot);
    }
    const auto found = tail.find(threshold, changed, static_cast<Index>(values.size()),
                                 [&](Index slot) { return values[slot]; });
    const std::set<Index> once(found.begin(), found.end());
    ASSERT_EQ(once.size(), found.size());
    for (Index slot = 0; slot < values.size(); ++slot)
      ASSERT_TRUE(once.contains(slot) || !(values[slot] >= threshold)) << "event " << event;
    for (const Index slot : found) ASSERT_GE(values[slot], threshold - 0.5);
    found_most = std::max(found_most, found.size());
  }
  EXPECT_GT(found_most, 20U);
  EXPECT_GT(falls, 20U);
}

TEST(RisingThreshold, LooksAtWhatChangedOnly) {
  RisingThreshold tail(0);
  std::size_t asked = 0;
  const auto value = [&](Index slot) {
    ++asked;
    return static_cast<double>(slot);
  };
  std::vector<Index> all(1000);
  for (Index slot = 0; slot < all.size(); ++slot) all[slot] = slot;
  EXPECT_EQ(tail.find(990, all, 1000, value).size(), 10U);
  asked = 0;
  EXPECT_EQ(tail.find(995, std::vector<Index>{3, 997}, 1000, value).size(), 5U);
  EXPECT_LE(asked, 12U);
  EXPECT_EQ(tail.find(500, {}, 1000, value).size(), 500U);
}

}  // namespace
}  // namespace burin
