#include <burin/host/percentile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace burin {
namespace {

TEST(Percentile, IsTheNearestRank) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1);
  std::shuffle(values.begin(), values.end(), std::mt19937(1));
  const Percentiles found = percentiles(values);
  EXPECT_EQ(found.p50, 50);
  EXPECT_EQ(found.p95, 95);
  EXPECT_EQ(found.p99, 99);
  EXPECT_EQ(found.max, 100);
}

/// The definition, word for word.
double smallest_covering(const std::vector<double>& values, double percent) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  for (const double value : sorted) {
    const auto covered = std::count_if(values.begin(), values.end(), [&](double v) { return v <= value; });
    if (static_cast<double>(covered) * 100 >= percent * static_cast<double>(values.size())) return value;
  }
  return -1;
}

TEST(Percentile, CoversTheShareOfAnyNumberOfValues) {
  std::mt19937 random(5);
  for (std::size_t count = 1; count < 250; ++count) {
    std::vector<double> values(count);
    for (double& value : values) value = static_cast<double>(random() % 50);
    const Percentiles found = percentiles(values);
    ASSERT_EQ(found.p50, smallest_covering(values, 50)) << count;
    ASSERT_EQ(found.p95, smallest_covering(values, 95)) << count;
    ASSERT_EQ(found.p99, smallest_covering(values, 99)) << count;
    ASSERT_EQ(found.max, *std::max_element(values.begin(), values.end())) << count;
  }
}

TEST(Percentile, OfNothingIsZero) { EXPECT_EQ(percentiles({}).max, 0); }

}  // namespace
}  // namespace burin
