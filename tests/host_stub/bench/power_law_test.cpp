#include <gtest/gtest.h>
#include <host_stub/bench/power_law.h>

#include <cmath>
#include <vector>

namespace burin {
namespace {

TEST(PowerLaw, FindsTheOneThatCostsFollow) {
  const std::vector<double> sizes = {1e3, 5e3, 2e4, 3e5};
  std::vector<double> costs;
  for (const double size : sizes) costs.push_back(3e-6 * std::pow(size, 1.07));
  const PowerLaw law = fit_power_law(sizes, costs);
  EXPECT_NEAR(law.exponent, 1.07, 1e-12);
  EXPECT_NEAR(law.factor, 3e-6, 1e-15);
  EXPECT_NEAR(law.standard_error, 0, 1e-7);
}

TEST(PowerLaw, TellsHowFarCostsStray) {
  // Logarithms (0, 0), (1, 2), (2, 1): slope 1/2, residuals -1/2, 1, -1/2, error sqrt(1.5 / 1 / 2).
  const std::vector<double> sizes = {1, std::exp(1), std::exp(2)}, costs = {1, std::exp(2), std::exp(1)};
  const PowerLaw law = fit_power_law(sizes, costs);
  EXPECT_NEAR(law.exponent, 0.5, 1e-12);
  EXPECT_NEAR(std::log(law.factor), 0.5, 1e-12);
  EXPECT_NEAR(law.standard_error, std::sqrt(0.75), 1e-12);
}

TEST(PowerLaw, GoesThroughTwoPoints) {
  const std::vector<double> sizes = {10, 1000}, costs = {2, 2};
  const PowerLaw law = fit_power_law(sizes, costs);
  EXPECT_NEAR(law.exponent, 0, 1e-12);
  EXPECT_NEAR(law.factor, 2, 1e-12);
  EXPECT_EQ(law.standard_error, 0);
}

}  // namespace
}  // namespace burin
