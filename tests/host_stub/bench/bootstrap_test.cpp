#include <gtest/gtest.h>
#include <host_stub/bench/bootstrap.h>

#include <cmath>
#include <random>
#include <vector>

namespace burin {
namespace {

TEST(Bootstrap, HasNoWidthWithoutSpread) {
  const std::vector<double> same(6, 1.25);
  const Estimate estimate = bootstrap_mean_ratio(same);
  EXPECT_NEAR(estimate.low, 1.25, 1e-12);
  EXPECT_NEAR(estimate.value, 1.25, 1e-12);
  EXPECT_NEAR(estimate.high, 1.25, 1e-12);
}

TEST(Bootstrap, TakesTheGeometricMean) {
  const std::vector<double> ratios = {0.5, 2};
  const Estimate estimate = bootstrap_mean_ratio(ratios);
  EXPECT_NEAR(estimate.value, 1, 1e-12);
  EXPECT_NEAR(estimate.low, 0.5, 1e-12) << "a quarter of the samples draws the lower ratio twice";
  EXPECT_NEAR(estimate.high, 2, 1e-12);
}

/// Ratios whose logarithms are normal.
std::vector<double> lognormal(std::mt19937_64& random, std::size_t count, double mean, double deviation) {
  std::normal_distribution<double> normal(mean, deviation);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < count; ++i) ratios.push_back(std::exp(normal(random)));
  return ratios;
}

TEST(Bootstrap, IsAsWideAsTheStandardErrorOfTheMeanTells) {
  std::mt19937_64 random(7);
  const std::vector<double> ratios = lognormal(random, 400, 0.1, 0.2);
  double mean = 0, variance = 0;
  for (const double ratio : ratios) mean += std::log(ratio) / 400;
  for (const double ratio : ratios) variance += std::pow(std::log(ratio) - mean, 2) / 400;
  const double error = std::sqrt(variance / 400);
  const Estimate estimate = bootstrap_mean_ratio(ratios);
  EXPECT_NEAR(std::log(estimate.value), mean, 1e-12);
  EXPECT_NEAR(std::log(estimate.low), mean - 1.96 * error, 0.1 * error);
  EXPECT_NEAR(std::log(estimate.high), mean + 1.96 * error, 0.1 * error);
}

TEST(Bootstrap, HoldsTheTrueRatioAboutAsOftenAsItSays) {
  std::mt19937_64 random(11);
  int held = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Estimate estimate = bootstrap_mean_ratio(lognormal(random, 30, std::log(1.1), 0.1));
    held += estimate.low <= 1.1 && 1.1 <= estimate.high ? 1 : 0;
  }
  EXPECT_GE(held, 176) << "of 200; 95 % are 190";
  EXPECT_LE(held, 199);
}

}  // namespace
}  // namespace burin
