#include "bench_brush/brush_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace burin::test {
namespace {

TEST(MeanRatio, HasTheIntervalThatHolds95Of100Times) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(std::log(1.5), 0.2);
  constexpr int repeats = 4000;
  int held = 0;
  for (int i = 0; i < repeats; ++i) {
    std::vector<double> ratios;
    for (int process = 0; process < measuring_processes; ++process) ratios.push_back(std::exp(noise(random)));
    const Estimate ratio = mean_ratio(ratios);
    held += ratio.low <= 1.5 && 1.5 <= ratio.high;
  }
  // Three standard deviations of such a count.
  EXPECT_NEAR(held, 0.95 * repeats, 3 * std::sqrt(repeats * 0.95 * 0.05));
}

}  // namespace
}  // namespace burin::test
