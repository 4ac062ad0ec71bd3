// Computes intervals of mean ratios by the percentile bootstrap [Efron & Tibshirani 1993, ch. 13], with a
// fixed seed.
#include "bench/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace burin {
namespace {

constexpr std::size_t resamples = 10000;

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::vector<double> resampled_means(const std::vector<double>& values) {
  std::mt19937_64 random(1);
  std::vector<double> means, sample(values.size());
  for (std::size_t i = 0; i < resamples; ++i) {
    // std::uniform_int_distribution is not used, since its results differ between standard libraries.
    for (double& value : sample) value = values[random() % values.size()];
    means.push_back(mean(sample));
  }
  return means;
}

}  // namespace

Estimate bootstrap_mean_ratio(std::span<const double> ratios) {
  if (ratios.empty()) return {};
  std::vector<double> logs;
  for (const double ratio : ratios) logs.push_back(std::log(ratio));
  std::vector<double> means = resampled_means(logs);
  std::sort(means.begin(), means.end());
  const auto at = [&](double share) {
    return std::exp(means[static_cast<std::size_t>(share * static_cast<double>(resamples))]);
  };
  return {at(0.025), std::exp(mean(logs)), at(0.975)};
}

}  // namespace burin
