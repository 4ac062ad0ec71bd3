#include <burin/stamp/stamp_image.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "images.h"

namespace burin {
namespace {

using test::random_image;

TEST(SampleBilinear, GoesOnBeyondTheBorderAsTheImageDoes) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> place(-1, 2);
  for (const Wrap wrap_u : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black})
    for (const Wrap wrap_v : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black}) {
      StampImage image = test::random_image(5, 4, 3, random);
      image.wrap_u = wrap_u;
      image.wrap_v = wrap_v;
      const StampImage around = test::extended(image, 20);
      for (int i = 0; i < 300; ++i) {
        const float u = place(random), v = place(random);
        ASSERT_NEAR(sample_bilinear(image, 1, u, v),
                    sample_bilinear(around, 1, (u * 5 + 20) / 45, (v * 4 + 20) / 44), 1e-5)
            << static_cast<int>(wrap_u) << " " << static_cast<int>(wrap_v) << ": " << u << " " << v;
      }
      EXPECT_TRUE(std::isfinite(sample_bilinear(image, 0, 1e30f, -1e30f)));
    }
}

TEST(SampleBilinear, IsZeroFarOutsideOfABlackImageAndTheCornerOutsideOfAClampedOne) {
  StampImage image{2, 2, 1, {1, 2, 3, 4}};
  image.wrap_u = image.wrap_v = Wrap::black;
  EXPECT_EQ(sample_bilinear(image, 0, -0.25f, 0.5f), 0);
  EXPECT_EQ(sample_bilinear(image, 0, 1e30f, 0.5f), 0);
  EXPECT_EQ(sample_bilinear(image, 0, 0, 0.25f), 0.5f);
  image.wrap_u = image.wrap_v = Wrap::clamp;
  EXPECT_EQ(sample_bilinear(image, 0, 1e30f, -1e30f), 2);
  EXPECT_EQ(sample_bilinear(image, 0, 0.1f, 1.5f), 3);
}

/// The sample as a sum over all texels of triangle-shaped weights, repeated with period 1.
double reference(const StampImage& image, int channel, double u, double v) {
  const auto weight = [](double turns, double centre, int size) {
    const double away = turns - centre;
    return std::max(0.0, 1 - std::abs(away - std::round(away)) * size);
  };
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += weight(u, (x + 0.5) / image.width, image.width) *
             weight(v, (y + 0.5) / image.height, image.height) *
             double{image.texels[static_cast<std::size_t>((y * image.width + x) * image.channels + channel)]};
  return sum;
}

TEST(SampleBilinear, AgreesWithADoubleReference) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> near(-3, 3), far(-5000, 5000);
  int negative = 0;
  for (const auto& [width, height, channels] :
       {std::array{8, 16, 1}, std::array{7, 5, 3}, std::array{2, 9, 4}, std::array{33, 2, 2}}) {
    const StampImage image = random_image(width, height, channels, random);
    for (int i = 0; i < 5000; ++i) {
      const float u = i % 4 ? near(random) : far(random), v = i % 3 ? near(random) : far(random);
      const int channel = i % channels;
      ASSERT_NEAR(sample_bilinear(image, channel, u, v), reference(image, channel, u, v), 1e-6)
          << u << " " << v;
      negative += u < 0 && v < 0;
    }
  }
  EXPECT_GT(negative, 3000);
}

TEST(SampleBilinear, RepeatsASingleTexel) {
  const StampImage image{1, 1, 2, {3, 4}, 3, 3};
  for (const float u : {-1.0f, -0.3f, 0.0f, 0.5f, 0.9f, 17.0f})
    EXPECT_EQ(sample_bilinear(image, 1, u, -u), 4);
}

TEST(SampleBilinear, IsExactAtTexelCentres) {
  std::mt19937 random(5);
  const StampImage image = random_image(64, 32, 2, random);
  for (const float shift : {0.0f, -1.0f, 1.0f, -700.0f, 4096.0f})
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x)
        ASSERT_EQ(sample_bilinear(image, 1, (static_cast<float>(x) + 0.5f) / 64 + shift,
                                  (static_cast<float>(y) + 0.5f) / 32 - shift),
                  image.texels[static_cast<std::size_t>((y * 64 + x) * 2 + 1)]);
}

TEST(SampleBilinear, IsContinuousAcrossTheBorder) {
  std::mt19937 random(6);
  const StampImage image = random_image(13, 21, 1, random);
  for (const float at : {-2.0f, -1.0f, 0.0f, 1.0f, 5.0f})
    for (float other = -1; other < 1; other += 0.013f) {
      const float below = std::nextafter(at, -100.0f), above = std::nextafter(at, 100.0f);
      ASSERT_NEAR(sample_bilinear(image, 0, below, other), sample_bilinear(image, 0, above, other), 1e-4);
      ASSERT_NEAR(sample_bilinear(image, 0, other, below), sample_bilinear(image, 0, other, above), 1e-4);
    }
  EXPECT_EQ(sample_bilinear(image, 0, -1e-30f, 0), sample_bilinear(image, 0, 0, 0));
}

TEST(SampleBilinear, GivesNaNForPlacesThatAreNotFinite) {
  const StampImage image{1, 1, 1, {3}, 3, 3};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    EXPECT_TRUE(std::isnan(sample_bilinear(image, 0, bad, 0)));
    EXPECT_TRUE(std::isnan(sample_bilinear(image, 0, 0, bad)));
  }
  EXPECT_EQ(sample_bilinear(image, 0, std::numeric_limits<float>::max(), -std::numeric_limits<float>::max()),
            3);
}

}  // namespace
}  // namespace burin
