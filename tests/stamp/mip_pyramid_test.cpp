#include <burin/base/error.h>
#include <burin/stamp/mip_pyramid.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <numbers>
#include <random>

#include "support/shared_data.h"

namespace burin {
namespace {

constexpr unsigned seed = 20050101;

/// Texel centres are at (x + 0.5, y + 0.5).
StampImage image_of(int width, int height, int channels, const std::function<float(int, int, int)>& value) {
  StampImage image{width, height, channels, {}, 0, 0};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < channels; ++channel) image.texels.push_back(value(x, y, channel));
  return image;
}

StampImage random_image(int width, int height, int channels, std::mt19937& random) {
  std::uniform_real_distribution<float> value(-1, 1);
  return image_of(width, height, channels, [&](int, int, int) { return value(random); });
}

float texel(const StampImage& image, int x, int y, int channel) {
  return image.texels[static_cast<std::size_t>((y * image.width + x) * image.channels + channel)];
}

double mean(const StampImage& image, int channel) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += double{texel(image, x, y, channel)};
  return sum / image.width / image.height;
}

float sample(const MipPyramid& pyramid, int channel, float u, float v, float footprint) {
  float value = 0;
  sample_mip(pyramid, channel, {{&u, 1}, {&v, 1}, {&footprint, 1}}, {&value, 1});
  return value;
}

TEST(MipPyramid, HalvesSizesDownToOneTexel) {
  const MipPyramid pyramid = make_mip_pyramid(image_of(13, 3, 2, [](int, int, int) { return 0.0f; }));
  std::vector<std::pair<int, int>> sizes;
  for (const StampImage& level : pyramid.levels) {
    sizes.emplace_back(level.width, level.height);
    EXPECT_EQ(level.texels.size(), static_cast<std::size_t>(2 * level.width * level.height));
  }
  EXPECT_EQ(sizes, (std::vector<std::pair<int, int>>{{13, 3}, {6, 1}, {3, 1}, {1, 1}}));
}

TEST(MipPyramid, OfAConstantIsThatConstantAtAnyFootprint) {
  const MipPyramid pyramid = make_mip_pyramid(image_of(37, 20, 1, [](int, int, int) { return 0.7f; }));
  for (const StampImage& level : pyramid.levels)
    for (const float value : level.texels) EXPECT_EQ(value, 0.7f);
  for (float footprint = 0; footprint < 100; footprint += 0.37f)
    EXPECT_NEAR(sample(pyramid, 0, 0.1f + footprint, -0.3f, footprint), 0.7f, 1e-7);
}

TEST(MipPyramid, KeepsTheMeanOfEveryChannel) {
  std::mt19937 random(seed);
  for (const auto& [width, height] : {std::pair{64, 64}, {63, 65}, {100, 7}, {1, 33}, {127, 129}}) {
    const MipPyramid pyramid = make_mip_pyramid(random_image(width, height, 3, random));
    for (const StampImage& level : pyramid.levels)
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(mean(level, channel), mean(pyramid.levels[0], channel), 1e-6)
            << width << " x " << height << " at " << level.width << " x " << level.height;
  }
}

/// Mean of a picture of constant texels over [x0, x1) x [y0, y1), by texels cut into 60 x 60 parts.
double cut_mean(const StampImage& image, double x0, double x1, double y0, double y1) {
  double sum = 0, count = 0;
  for (int y = 0; y < 60 * image.height; ++y)
    for (int x = 0; x < 60 * image.width; ++x) {
      const double at_x = (x + 0.5) / 60, at_y = (y + 0.5) / 60;
      if (at_x < x0 || at_x >= x1 || at_y < y0 || at_y >= y1) continue;
      sum += double{texel(image, x / 60, y / 60, 0)};
      ++count;
    }
  return sum / count;
}

// 60 is a multiple of 1 to 6, so no part is cut by a texel of the level above.
TEST(MipPyramid, OfAnOddSizeAveragesAreas) {
  std::mt19937 random(seed);
  const MipPyramid pyramid = make_mip_pyramid(random_image(11, 9, 1, random));
  const StampImage& level = pyramid.levels[1];
  ASSERT_EQ(level.width, 5);
  ASSERT_EQ(level.height, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x)
      EXPECT_NEAR(texel(level, x, y, 0),
                  cut_mean(pyramid.levels[0], x * 2.2, (x + 1) * 2.2, y * 2.25, (y + 1) * 2.25), 1e-6);
}

/// The image moved right and down by so many texels, around the border.
StampImage rolled(const StampImage& image, int by) {
  return image_of(image.width, image.height, image.channels, [&](int x, int y, int channel) {
    return texel(image, (x + image.width - by) % image.width, (y + image.height - by) % image.height,
                 channel);
  });
}

TEST(SampleMip, KnowsNoBorder) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, 1), width(0, 20);
  const StampImage image = random_image(64, 64, 1, random);
  const MipPyramid pyramid = make_mip_pyramid(image), moved = make_mip_pyramid(rolled(image, 16));
  int across = 0;
  for (int i = 0; i < 5000; ++i) {
    const float u = place(random), v = place(random), footprint = std::min(width(random), 16.0f);
    ASSERT_NEAR(sample(pyramid, 0, u, v, footprint), sample(moved, 0, u + 0.25f, v - 0.75f, footprint), 2e-5)
        << "seed " << seed << ": " << u << " " << v << " " << footprint;
    across += u > 0.75f || v > 0.75f;
  }
  EXPECT_GT(across, 1000);
}

TEST(SampleMip, IsTheBilinearSampleOfTheLevelThatFits) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-3, 3);
  const MipPyramid pyramid = make_mip_pyramid(random_image(37, 64, 2, random));
  const std::size_t last = pyramid.levels.size() - 1;
  for (int i = 0; i < 2000; ++i) {
    const float u = place(random), v = place(random);
    for (const float fine : {-1.0f, 0.0f, 0.4f, 1.0f})
      ASSERT_EQ(sample(pyramid, 1, u, v, fine), sample_bilinear(pyramid.levels[0], 1, u, v));
    for (std::size_t level = 0; level <= last; ++level)
      ASSERT_EQ(sample(pyramid, 1, u, v, std::exp2(static_cast<float>(level))),
                sample_bilinear(pyramid.levels[level], 1, u, v));
    for (const float coarse : {1e6f, 1e38f, std::numeric_limits<float>::infinity()})
      ASSERT_EQ(sample(pyramid, 1, u, v, coarse), sample_bilinear(pyramid.levels[last], 1, u, v));
    const float a = sample(pyramid, 1, u, v, 4), b = sample(pyramid, 1, u, v, 8);
    ASSERT_NEAR(sample(pyramid, 1, u, v, 5), 0.75f * a + 0.25f * b, 1e-6);
  }
}

/// Root of the mean squared difference between samples at a footprint of 4 texels and the mean of 32 x 32
/// bilinear samples over that area, for waves of so many texels along u.
double error_at_four_to_one(double wave) {
  constexpr int size = 1024;
  const StampImage image = image_of(size, 8, 1, [&](int x, int, int) {
    return static_cast<float>(std::sin(2 * std::numbers::pi * std::round(size / wave) * (x + 0.5) / size));
  });
  const MipPyramid pyramid = make_mip_pyramid(image);
  double squares = 0;
  constexpr int places = 777;
  for (int i = 0; i < places; ++i) {
    const double u = (i + 0.3) / places;
    double fine = 0;
    for (int part = 0; part < 32; ++part)
      fine +=
          double{sample_bilinear(image, 0, static_cast<float>(u + ((part + 0.5) / 32 - 0.5) * 4 / size), 0)};
    squares += std::pow(double{sample(pyramid, 0, static_cast<float>(u), 0, 4)} - fine / 32, 2);
  }
  return std::sqrt(squares / places);
}

// Long waves lose some of their crests to the blend of two texels of level 2. Those of 3 texels, which
// bilinear samples would show at full height (RMS 0.7), shrink to a fifth in the mean over 4 texels, and to
// nothing here.
TEST(SampleMip, ShowsWavesAsSupersamplingDoes) {
  const double slow = error_at_four_to_one(64), medium = error_at_four_to_one(32),
               fast = error_at_four_to_one(3);
  std::cout << "RMS against supersampling at 4:1: " << slow << " (64 texels a wave), " << medium << " (32), "
            << fast << " (3)\n";
  EXPECT_LT(slow, 0.01);
  EXPECT_LT(medium, 0.04);
  EXPECT_LT(fast, 0.2);
}

TEST(SampleMip, GivesNaNForPlacesThatAreNotFinite) {
  const MipPyramid pyramid = make_mip_pyramid(image_of(4, 4, 1, [](int, int, int) { return 1.0f; }));
  const float nan = std::numeric_limits<float>::quiet_NaN(), far = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(std::isnan(sample(pyramid, 0, nan, 0, 1)));
  EXPECT_TRUE(std::isnan(sample(pyramid, 0, 0, far, 1)));
  EXPECT_TRUE(std::isnan(sample(pyramid, 0, 0, 0, nan)));
}

TEST(SampleMip, RefusesArraysOfDifferentLengths) {
  const MipPyramid pyramid = make_mip_pyramid(image_of(4, 4, 1, [](int, int, int) { return 1.0f; }));
  const std::vector<float> three(3), two(2);
  std::vector<float> values(3);
  EXPECT_THROW(sample_mip(pyramid, 0, {three, two, three}, values), ContractError);
}

TEST(MipPyramid, OfARealStampKeepsItsMean) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/Leather031_height_1024_half_zip.exr");
  const MipPyramid pyramid = make_mip_pyramid(read_stamp(path));
  ASSERT_EQ(pyramid.levels.size(), 11U);
  EXPECT_NEAR(mean(pyramid.levels.back(), 0), mean(pyramid.levels.front(), 0), 1e-6);
  EXPECT_GE(pyramid.levels[3].minimum, pyramid.levels[0].minimum);
  EXPECT_LE(pyramid.levels[3].maximum, pyramid.levels[0].maximum);
}

}  // namespace
}  // namespace burin
