#include <burin/feature/smooth_offsets.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace burin::test {
namespace {

constexpr int count = 80;
const std::vector<double> straight(count, 0.);

std::vector<WeightedValue> weighted(double (*value)(int), double weight = 1) {
  std::vector<WeightedValue> values;
  for (int i = 0; i < count; ++i) values.push_back({value(i), weight});
  return values;
}

TEST(SmoothOffsets, KeepArcsUpToTheirEnds) {
  const auto arc = [](int i) { return 0.01 * i * i - 0.3 * i + 2; };
  const std::vector<double> smooth = smooth_offsets(weighted(arc), straight, 1e6);
  for (int i = 0; i < count; ++i) EXPECT_NEAR(smooth[static_cast<std::size_t>(i)], arc(i), 1e-6);
}

TEST(SmoothOffsets, FlattenShortWavesAndKeepLongOnes) {
  // 2 pi stiffness^(1/6) is 12.6 here.
  const auto greatest = [](double (*wave)(int)) {
    const std::vector<double> smooth = smooth_offsets(weighted(wave), straight, 64);
    return *std::max_element(smooth.begin() + 20, smooth.end() - 20);
  };
  EXPECT_LT(greatest([](int i) { return std::sin(i * 2 * std::numbers::pi / 5); }), 0.02);
  EXPECT_GT(greatest([](int i) { return std::sin(i * 2 * std::numbers::pi / 40); }), 0.98);
}

TEST(SmoothOffsets, SmoothTheMovedCurveNotItsDistance) {
  // The curve trembles and the line to which it moves is straight: its offsets tremble the other way.
  std::mt19937 random(5);
  std::vector<double> tremor, bends(count);
  for (int i = 0; i < count; ++i) tremor.push_back(static_cast<double>(random() % 1000) / 1000);
  for (std::size_t i = 1; i + 1 < count; ++i) bends[i] = tremor[i - 1] - 2 * tremor[i] + tremor[i + 1];
  std::vector<WeightedValue> values;
  for (const double x : tremor) values.push_back({3 - x, 1});
  const std::vector<double> smooth = smooth_offsets(values, bends, 1e6);
  for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(smooth[i] + tremor[i], 3, 1e-6);
}

TEST(SmoothOffsets, FollowHeavyValues) {
  std::vector<WeightedValue> values = weighted([](int) { return 0.; }, 1e-3);
  for (std::size_t i = 30; i < 50; ++i) values[i] = {1, 1};
  const std::vector<double> smooth = smooth_offsets(values, straight, 1);
  EXPECT_NEAR(smooth[40], 1, 0.01);
  EXPECT_NEAR(smooth[5], 0, 0.2);
}

}  // namespace
}  // namespace burin::test
