#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/mip_pyramid.h>
#include <gtest/gtest.h>

#include <random>

#include "images.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using test::extended, test::image_of, test::random_image, test::texel;

constexpr unsigned pyramid_seed = 20050101;

double mean(const StampImage& image, int channel) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += double{texel(image, x, y, channel)};
  return sum / image.width / image.height;
}

TEST(MipPyramid, HalvesSizesDownToOneTexel) {
  const MipPyramid pyramid = make_mip_pyramid(image_of(13, 3, 2, [](int, int, int) { return 0.0f; }));
  std::vector<std::pair<int, int>> sizes;
  for (const MipLevel& level : pyramid.levels) {
    sizes.emplace_back(level.image.width, level.image.height);
    EXPECT_EQ(level.image.texels.size(), static_cast<std::size_t>(2 * level.width() * level.height()));
  }
  EXPECT_EQ(sizes, (std::vector<std::pair<int, int>>{{13, 3}, {6, 1}, {3, 1}, {1, 1}}));
}

TEST(MipPyramid, OfAConstantIsThatConstant) {
  const MipPyramid pyramid = make_mip_pyramid(image_of(37, 20, 1, [](int, int, int) { return 0.7f; }));
  for (const MipLevel& level : pyramid.levels)
    for (const float value : level.image.texels) EXPECT_EQ(value, 0.7f);
}

TEST(MipPyramid, KeepsTheMeanOfEveryChannel) {
  std::mt19937 random(pyramid_seed);
  for (const auto& [width, height] : {std::pair{64, 64}, {63, 65}, {100, 7}, {1, 33}, {127, 129}}) {
    const MipPyramid pyramid = make_mip_pyramid(random_image(width, height, 3, random));
    for (const MipLevel& level : pyramid.levels)
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(mean(level.image, channel), mean(pyramid.stamp(), channel), 1e-6)
            << width << " x " << height << " at " << level.width() << " x " << level.height();
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
  std::mt19937 random(pyramid_seed);
  const MipPyramid pyramid = make_mip_pyramid(random_image(11, 9, 1, random));
  const StampImage& level = pyramid.levels[1].image;
  ASSERT_EQ(level.width, 5);
  ASSERT_EQ(level.height, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x)
      EXPECT_NEAR(texel(level, x, y, 0),
                  cut_mean(pyramid.stamp(), x * 2.2, (x + 1) * 2.2, y * 2.25, (y + 1) * 2.25), 1e-6);
}

// An oracle without borders: the pyramid of the image with a whole image around it, whose texels lie as
// those of the image's own pyramid.
TEST(MipPyramid, GoesOnBeyondTheBorderAsTheImageDoes) {
  std::mt19937 random(pyramid_seed);
  for (const Wrap u : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black})
    for (const Wrap v : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black}) {
      StampImage image = random_image(16, 32, 2, random);
      image.wrap_u = u;
      image.wrap_v = v;
      const MipPyramid pyramid = make_mip_pyramid(image), around = make_mip_pyramid(extended(image, 32));
      for (std::size_t k = 0; k < pyramid.levels.size(); ++k) {
        const auto& [level, ring_u, ring_v] = pyramid.levels[k];
        const int margin = 32 >> k;
        for (int y = -margin; y < (32 >> k) + margin; ++y)
          for (int x = -margin; x < std::max(16 >> k, 1) + margin; ++x) {
            if (k == 5) continue;  // 16 texels have no sixth level
            const std::ptrdiff_t column = wrapped_index(x + ring_u, level.width, u);
            const std::ptrdiff_t row = wrapped_index(y + ring_v, level.height, v);
            const float value =
                column < 0 || row < 0 ? 0 : texel(level, static_cast<int>(column), static_cast<int>(row), 1);
            ASSERT_NEAR(value, texel(around.levels[k].image, x + margin, y + margin, 1), 1e-6)
                << static_cast<int>(u) << " " << static_cast<int>(v) << " level " << k << ": " << x << " "
                << y;
          }
      }
    }
}

TEST(MipPyramid, OfARealStampKeepsItsMean) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/Leather031_height_1024_half_zip.exr");
  const MipPyramid pyramid = make_mip_pyramid(read_stamp(path));
  ASSERT_EQ(pyramid.levels.size(), 11U);
  EXPECT_NEAR(mean(pyramid.levels.back().image, 0), mean(pyramid.stamp(), 0), 1e-6);
}

}  // namespace
}  // namespace burin
