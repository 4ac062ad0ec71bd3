#include <burin/plugin/noise.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace burin {
namespace {

using plugin::FractalNoise;
using plugin::GradientNoise;

TEST(GradientNoise, LiesWithinOneAroundZero) {
  double sum = 0, squares = 0;
  float most = 0;
  constexpr int n = 1000;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const float noise = GradientNoise(3)(0.37 * i - 100, 0.41 * j - 100);
      sum += static_cast<double>(noise);
      squares += static_cast<double>(noise * noise);
      most = std::max(most, std::abs(noise));
    }
  }
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.85f);
  EXPECT_NEAR(sum / (n * n), 0, 0.003);
  EXPECT_NEAR(std::sqrt(squares / (n * n)), 0.33, 0.03);
}

TEST(GradientNoise, IsZeroWithASlopeAtLatticePoints) {
  const GradientNoise noise(4);
  for (int i = -20; i < 20; ++i) {
    EXPECT_EQ(noise(i, 3 * i), 0);
    const double slope = std::hypot(noise(i + 1e-3, i), noise(i, i + 1e-3)) / 1e-3;
    EXPECT_NEAR(slope, std::sqrt(2.0), 0.01) << "unit gradients, scaled";
  }
}

TEST(GradientNoise, HasNoSteps) {
  const GradientNoise noise(5);
  for (int i = -5000; i < 5000; ++i) {
    const double x = 1e-3 * i, y = 0.7e-3 * i;
    EXPECT_LT(std::abs(noise(x + 1e-3, y) - noise(x, y)), 4e-3f);
    EXPECT_LT(std::abs(noise(x, y + 1e-3) - noise(x, y)), 4e-3f);
  }
}

TEST(GradientNoise, RepeatsAfterItsPeriod) {
  const GradientNoise noise(6);
  float difference = 0;
  for (int i = -100; i < 100; ++i) {
    const double x = 0.173 * i, y = 0.31 * i;
    EXPECT_NEAR(noise(x, y, 7), noise(x + 7, y, 7), 1e-5f);
    EXPECT_NEAR(noise(x, y, 7), noise(x - 21, y, 7), 1e-5f);
    difference += std::abs(noise(x, y, 7) - noise(x + 3, y, 7));
  }
  EXPECT_GT(difference, 10);
}

/// Share of the energy along x above a number of cycles a cell, of rows across a period.
double energy_above(double cycles) {
  constexpr int period = 16, per_cell = 16, samples = period * per_cell, rows = 64;
  std::vector<std::complex<double>> turns(samples);
  for (int i = 0; i < samples; ++i) turns[i] = std::polar(1.0, 2 * std::numbers::pi * i / samples);
  double all = 0, above = 0;
  for (int row = 0; row < rows; ++row) {
    std::vector<double> line(samples);
    for (int i = 0; i < samples; ++i)
      line[i] = static_cast<double>(GradientNoise(8)(static_cast<double>(i) / per_cell, 0.71 * row, period));
    for (int wave = 1; wave < samples / 2; ++wave) {
      std::complex<double> sum = 0;
      for (int i = 0; i < samples; ++i) sum += line[i] * turns[wave * i % samples];
      all += std::norm(sum);
      if (wave > cycles * period) above += std::norm(sum);
    }
  }
  return above / all;
}

TEST(GradientNoise, HasLittleEnergyAboveItsBand) {
  EXPECT_LT(energy_above(1), 0.01);
  EXPECT_LT(energy_above(2), 1e-3);
  EXPECT_GT(energy_above(0.25), 0.5);
}

TEST(FractalNoise, AddsOctavesOfHalfTheSize) {
  const FractalNoise fractal(9, {.count = 3, .gain = 0.5f});
  const auto octave = [](std::uint64_t i) { return GradientNoise(plugin::Random::splitmix64(9, i)); };
  for (int i = 0; i < 100; ++i) {
    const double x = 0.31 * i, y = 0.17 * i;
    const float sum = octave(0)(x, y) + octave(1)(2 * x, 2 * y) / 2 + octave(2)(4 * x, 4 * y) / 4;
    EXPECT_NEAR(fractal(x, y, 0, 0), sum / 1.75f, 1e-6f);
  }
}

TEST(FractalNoise, FadesOctavesOutBeforeTwoNodesACell) {
  const FractalNoise fractal(9, {.count = 2, .gain = 1});
  const GradientNoise first(plugin::Random::splitmix64(9, 0));
  EXPECT_EQ(fractal(0.3, 0.4, 0.5, 0), 0);
  EXPECT_EQ(fractal(0.3, 0.4, 0, 0.5), 0);
  EXPECT_EQ(fractal(0.3, 0.4, 0.25, 0.25), first(0.3, 0.4) / 2) << "the first in full, the second not at all";
  EXPECT_NE(fractal(0.3, 0.4, 0.2, 0.2), first(0.3, 0.4) / 2);
  EXPECT_EQ(fractal(0.3, 0.4, 0.1, 0.12), fractal(0.3, 0.4, 0, 0));
}

TEST(FractalNoise, RepeatsAfterItsPeriodInEveryOctave) {
  const FractalNoise fractal(9, {.count = 5, .period = 3});
  for (int i = 0; i < 100; ++i)
    EXPECT_NEAR(fractal(0.11 * i, 0.3, 0, 0), fractal(0.11 * i + 3, 0.3, 0, 0), 2e-5f);
}

}  // namespace
}  // namespace burin
