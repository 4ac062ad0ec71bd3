#include <burin/stamp/area_filter.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>

#include "images.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using test::extended, test::image_of, test::random_image;

constexpr unsigned seed = 20051122;

/// An area of so many texels along and across, turned by an angle.
SampleArea area_of(const StampImage& image, double along, double across, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), w = image.width, h = image.height;
  return {static_cast<float>(along * c / w), static_cast<float>(along * s / h),
          static_cast<float>(-across * s / w), static_cast<float>(across * c / h)};
}

/// Mean of bilinear samples at those of 64 x 64 places in the parallelogram that lie in its ellipse.
double supersampled(const StampImage& image, float u, float v, const SampleArea& area) {
  double sum = 0;
  int count = 0;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const double x = (i + 0.5) / 32 - 1, y = (j + 0.5) / 32 - 1;
      if (x * x + y * y > 1) continue;
      sum +=
          double{sample_bilinear(image, 0, static_cast<float>(u + (x * area.along_u + y * area.across_u) / 2),
                                 static_cast<float>(v + (x * area.along_v + y * area.across_v) / 2))};
      ++count;
    }
  return sum / count;
}

/// RMS of the difference from supersampling, in parts of the image's range.
double rms_error(const StampImage& image, double along, double across, double angle, int places = 150) {
  const MipPyramid pyramid = make_mip_pyramid(image);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 2);
  const SampleArea area = area_of(image, along, across, angle);
  double squares = 0;
  for (int i = 0; i < places; ++i) {
    const float u = place(random), v = place(random);
    squares += std::pow(double{sample_area(pyramid, 0, u, v, area)} - supersampled(image, u, v, area), 2);
  }
  return std::sqrt(squares / places) / (image.maximum - image.minimum);
}

struct Shape {
  double along, across, degrees, most;
};

// At one to one the area is a point, bit for bit. The last column is the greatest error allowed.
constexpr std::array shapes = {
    Shape{1, 1, 0, 0.013},  Shape{2, 1, 0, 0.002},   Shape{4, 1, 0, 0.003},   Shape{4, 1, 30, 0.002},
    Shape{4, 1, 90, 0.002}, Shape{4, 0, 0, 0.004},   Shape{4, 2, 15, 0.002},  Shape{8, 1, 45, 0.001},
    Shape{8, 2, 70, 0.001}, Shape{4, 4, 0, 0.001},   Shape{6, 6, 0, 0.005},   Shape{8, 8, 0, 0.008},
    Shape{12, 12, 0, 0.01}, Shape{16, 4, 20, 0.001}, Shape{24, 6, 20, 0.004}, Shape{32, 8, 60, 0.005},
};

void expect_supersampled(const char* name, const StampImage& image) {
  std::cout << name << ", RMS against supersampling:";
  for (const auto& [along, across, degrees, most] : shapes) {
    const double error = rms_error(image, along, across, degrees * std::numbers::pi / 180);
    std::cout << " " << along << "x" << across << "@" << degrees << " " << 100 * error << " %";
    EXPECT_LE(error, most) << name << ": " << along << " x " << across << " texels at " << degrees;
  }
  std::cout << "\n";
}

TEST(SampleArea, IsTheMeanOfRealTiles) {
  for (const char* name : {"Rock035_height_1024_half_zip.exr", "Leather031_height_1024_half_zip.exr",
                           "PavingStones098_height_1024_half_piz.exr"}) {
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("stamps/") + name);
    expect_supersampled(name, read_stamp(path));
  }
}

TEST(SampleArea, IsTheMeanOfWavesOfManyLengths) {
  StampImage image = image_of(512, 256, 1, [](int x, int y, int) {
    double sum = 0;
    for (int k = 0; k < 6; ++k)
      sum += std::sin(2 * std::numbers::pi * ((3 << k) * x / 512.0 + (5 << k) * y / 256.0)) / (1 << k);
    return static_cast<float>(sum);
  });
  set_range(image);
  expect_supersampled("waves", image);
}

// The hardest image: nothing about a texel follows from its neighbours.
TEST(SampleArea, IsTheMeanOfNoise) {
  std::mt19937 random(seed);
  StampImage image = random_image(256, 256, 1, random);
  set_range(image);
  EXPECT_LE(rms_error(image, 4, 1, 0), 0.006);
  EXPECT_LE(rms_error(image, 4, 1, 0.5), 0.004);
  EXPECT_LE(rms_error(image, 4, 4, 0), 0.001);
  EXPECT_LE(rms_error(image, 8, 8, 0), 0.02);
}

// Waves along u, then along v: what the averages of the pyramid blur is taken off the ellipse.
TEST(SampleArea, IsNoWiderThanTheArea) {
  for (const bool along_v : {false, true}) {
    StampImage image = image_of(256, 256, 1, [&](int x, int y, int) {
      return static_cast<float>(std::cos(2 * std::numbers::pi * (along_v ? y : x) / 32));
    });
    set_range(image);
    for (const double size : {8.0, 10.0}) {
      const double error = rms_error(image, size, size, 0);
      std::cout << "waves of 32 texels, area of " << size << ": " << 100 * error << " %\n";
      EXPECT_LE(error, 0.001) << size;
    }
  }
}

TEST(SampleArea, IsBilinearWhereNoLongerThanATexel) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-3, 3), size(0, 0.999f), angle(0, 7);
  for (const Wrap wrap : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black}) {
    StampImage image = random_image(37, 64, 3, random);
    image.wrap_u = image.wrap_v = wrap;
    const MipPyramid pyramid = make_mip_pyramid(image);
    for (int i = 0; i < 2000; ++i) {
      const float u = place(random), v = place(random);
      ASSERT_EQ(sample_area(pyramid, 2, u, v, area_of(image, size(random), size(random), angle(random))),
                sample_bilinear(image, 2, u, v));
      ASSERT_EQ(sample_area(pyramid, 2, u, v, {0, 0, 0, 0}), sample_bilinear(image, 2, u, v));
    }
  }
}

// Whichever parallelogram it is inscribed in, an ellipse is the same.
TEST(SampleArea, KnowsTheEllipseNotTheParallelogram) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, 1), size(1, 12), angle(0, 7);
  const StampImage image = random_image(64, 64, 1, random);
  const MipPyramid pyramid = make_mip_pyramid(image);
  for (int i = 0; i < 500; ++i) {
    const float u = place(random), v = place(random), turn = angle(random);
    const SampleArea a = area_of(image, size(random), size(random), angle(random));
    const float c = std::cos(turn), s = std::sin(turn);
    const SampleArea b{c * a.along_u + s * a.across_u, c * a.along_v + s * a.across_v,
                       c * a.across_u - s * a.along_u, c * a.across_v - s * a.along_v};
    ASSERT_NEAR(sample_area(pyramid, 0, u, v, a), sample_area(pyramid, 0, u, v, b), 1e-4);
  }
}

// Off a slope of 0.02 a texel by what 2 % of a texel make.
TEST(SampleArea, KeepsConstantsAndSlopes) {
  const StampImage image = image_of(
      256, 256, 3, [](int x, int y, int c) { return c == 1 ? 0.7f : 0.01f * static_cast<float>(x - 2 * y); });
  const MipPyramid pyramid = make_mip_pyramid(image);
  for (double size = 0; size < 40; size += 0.37) {
    const SampleArea area = area_of(image, size, size / 3, size);
    EXPECT_NEAR(sample_area(pyramid, 1, 0.1f, 7.3f, area), 0.7f, 1e-6);
    EXPECT_NEAR(sample_area(pyramid, 0, 0.5f, 0.45f, area), sample_bilinear(image, 0, 0.5f, 0.45f), 4e-4)
        << size;
  }
}

/// The greatest step of the sample while area(0) becomes area(1) in so many steps.
template <class Area>
double greatest_step(const MipPyramid& pyramid, float u, float v, int steps, const Area& area) {
  double greatest = 0;
  float last = sample_area(pyramid, 0, u, v, area(0.0));
  for (int i = 1; i <= steps; ++i) {
    const float now = sample_area(pyramid, 0, u, v, area(static_cast<double>(i) / steps));
    greatest = std::max(greatest, std::abs(double{now - last}));
    last = now;
  }
  return greatest;
}

// Finer steps of the area give steps of the sample as much finer: no jump hides in them.
TEST(SampleArea, IsContinuousInTheArea) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, 1);
  std::uniform_real_distribution<double> size(0, 1), angle(0, 7);
  const StampImage image = random_image(64, 64, 1, random);
  const MipPyramid pyramid = make_mip_pyramid(image);
  for (int i = 0; i < 12; ++i) {
    const float u = place(random), v = place(random);
    const double long0 = 24 * size(random), long1 = 24 * size(random), short0 = 8 * size(random),
                 short1 = 8 * size(random), turn0 = angle(random), turn1 = angle(random);
    const auto area = [&](double s) {
      return area_of(image, long0 + s * (long1 - long0), short0 + s * (short1 - short0),
                     turn0 + s * (turn1 - turn0));
    };
    EXPECT_LT(greatest_step(pyramid, u, v, 20000, area), 3e-3) << "seed " << seed << " path " << i;
  }
  const auto growing = [&](double s) { return area_of(image, 40 * s, 40 * s, 0); };
  EXPECT_LT(greatest_step(pyramid, 0.3f, 0.6f, 40000, growing), 3e-3);
  const auto through_a_circle = [&](double s) { return area_of(image, 5 + s, 5.5, 0.4); };
  EXPECT_LT(greatest_step(pyramid, 0.3f, 0.6f, 5000, through_a_circle), 3e-4);
}

TEST(SampleArea, IsContinuousInThePlace) {
  std::mt19937 random(seed);
  for (const Wrap wrap : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black}) {
    StampImage image = random_image(32, 32, 1, random);
    image.wrap_u = image.wrap_v = wrap;
    const MipPyramid pyramid = make_mip_pyramid(image);
    const SampleArea area = area_of(image, 5, 2, 0.3);
    float last = sample_area(pyramid, 0, -2, 1, area);
    for (int i = 0; i < 40000; ++i) {
      const float s = -2 + static_cast<float>(i) / 10000;
      const float now = sample_area(pyramid, 0, s, 1 + s / 3, area);
      if (i > 0) {
        ASSERT_NEAR(now, last, 0.01) << s;
      }
      last = now;
    }
  }
}

// The oracle is the image with whole images around it, sampled far from its own border.
TEST(SampleArea, GoesOnBeyondTheBorderAsTheImageDoes) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-0.03f, 0.15f), size(0, 12), angle(0, 7);
  int beyond = 0;
  for (const Wrap wrap_u : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black})
    for (const Wrap wrap_v : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black}) {
      StampImage image = random_image(64, 64, 3, random);
      image.wrap_u = wrap_u;
      image.wrap_v = wrap_v;
      const MipPyramid pyramid = make_mip_pyramid(image), around = make_mip_pyramid(extended(image, 64));
      for (int i = 0; i < 300; ++i) {
        const float u = i % 2 ? place(random) : 1 - place(random),
                    v = i % 3 ? place(random) : 1 - place(random);
        const SampleArea area = area_of(image, size(random), size(random), angle(random));
        ASSERT_NEAR(sample_area(pyramid, 1, u, v, area),
                    sample_area(around, 1, (u + 1) / 3, (v + 1) / 3,
                                {area.along_u / 3, area.along_v / 3, area.across_u / 3, area.across_v / 3}),
                    1e-4)
            << "seed " << seed << ", wrap " << static_cast<int>(wrap_u) << " " << static_cast<int>(wrap_v)
            << ": " << u << " " << v;
        beyond += std::abs(u - 0.5f) > 0.5f || std::abs(v - 0.5f) > 0.5f;
      }
    }
  EXPECT_GT(beyond, 500);
}

TEST(SampleArea, IsTheBorderFarFromAClampedImageAndZeroFarFromABlackOne) {
  StampImage image = image_of(32, 16, 1, [](int x, int y, int) {
    return x == 0 ? 2.0f : x == 31 ? 5.0f : static_cast<float>(x * y);
  });
  for (const double size : {0.0, 1.5, 3.0, 9.0, 40.0}) {
    const SampleArea area = area_of(image, size, size / 2, 0.4);
    image.wrap_u = Wrap::clamp;
    EXPECT_NEAR(sample_area(make_mip_pyramid(image), 0, -1, 0.3f, area), 2, 1e-5) << size;
    EXPECT_NEAR(sample_area(make_mip_pyramid(image), 0, 3e30f, 0.3f, area), 5, 1e-5) << size;
    image.wrap_u = Wrap::black;
    EXPECT_EQ(sample_area(make_mip_pyramid(image), 0, -1, 0.3f, area), 0) << size;
  }
}

TEST(SampleArea, BecomesTheMeanOfTheWholeTile) {
  std::mt19937 random(seed);
  const StampImage image = random_image(48, 20, 1, random);
  double mean = 0;
  for (const float texel : image.texels) mean += double{texel} / static_cast<double>(image.texels.size());
  const MipPyramid pyramid = make_mip_pyramid(image);
  for (const float size : {50.0f, 1e4f, 1e15f})
    EXPECT_NEAR(sample_area(pyramid, 0, 0.3f, 0.8f, {size, 0, 0, size}), mean, 1e-5) << size;
  EXPECT_TRUE(std::isfinite(sample_area(pyramid, 0, 0.3f, 0.8f, {1e15f, 1e15f, 1e-9f, 0})));
}

TEST(SampleArea, GivesNaNForNumbersThatAreNotFinite) {
  const MipPyramid pyramid = make_mip_pyramid(image_of(4, 4, 1, [](int, int, int) { return 1.0f; }));
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_TRUE(std::isnan(sample_area(pyramid, 0, bad, 0, {1, 0, 0, 1})));
    EXPECT_TRUE(std::isnan(sample_area(pyramid, 0, 0, bad, {1, 0, 0, 1})));
    EXPECT_TRUE(std::isnan(sample_area(pyramid, 0, 0, 0, {bad, 0, 0, 1})));
    EXPECT_TRUE(std::isnan(sample_area(pyramid, 0, 0, 0, {1, 0, 0, bad})));
  }
}

}  // namespace
}  // namespace burin
