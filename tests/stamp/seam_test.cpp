#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/seam.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "images.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using test::image_of;

struct RealSeam {
  const char* name;
  double x, y;  // as SOURCES.md of the files states them
  SeamVerdict verdict;
};

TEST(Seam, IsMeasuredAndJudgedOnRealStamps) {
  for (const RealSeam& expected : {
           RealSeam{"Rock035_height_1024_half_zip.exr", 0.91, 0.64, SeamVerdict::tiles},
           RealSeam{"Leather031_height_1024_half_zip.exr", 0.99, 0.78, SeamVerdict::tiles},
           RealSeam{"PavingStones098_height_1024_half_piz.exr", 0.98, 1.15, SeamVerdict::tiles},
           RealSeam{"Sponge001_height_512_float_zips.exr", 1.08, 0.89, SeamVerdict::tiles},
           RealSeam{"bluenoise_256_HDR_L_0_u16.png", 1.00, 0.97, SeamVerdict::tiles},
           RealSeam{"t3d_terrain3.exr", 81.15, 30.27, SeamVerdict::does_not_tile},
           RealSeam{"oexr_GrayRampsDiagonal.exr", 224.90, 2.34, SeamVerdict::does_not_tile},
       }) {
    SCOPED_TRACE(expected.name);
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("stamps/") + expected.name);
    const Seam seam = measure_seam(read_stamp(path));
    EXPECT_NEAR(seam.x.over_interior, expected.x, 0.005);
    EXPECT_NEAR(seam.y.over_interior, expected.y, 0.005);
    EXPECT_EQ(seam.verdict, expected.verdict);
  }
}

// Steeper at its border than elsewhere: the steps beside the border tell.
TEST(Seam, OfAPatternThatIsSteepAtItsBorderIsNone) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/oexr_PeriodicPattern.exr");
  const Seam seam = measure_seam(read_stamp(path));
  EXPECT_NEAR(seam.x.over_beside, 0.99, 0.005);
  EXPECT_NEAR(seam.y.over_beside, 0.99, 0.005);
  EXPECT_GT(seam.x.over_interior, 2);
  EXPECT_EQ(seam.verdict, SeamVerdict::tiles);
}

TEST(Seam, OfStampsWithGroundAroundThemIsPadding) {
  for (const char* name :
       {"t3d_stones.exr", "t3d_acrylic1.exr", "t3d_texture1.exr", "t3d_mountain1.exr", "t3d_hill1.exr",
        "t3d_square5.exr", "vdm_spot_head_256_float_zip.exr", "vdm_spot_horn_128_half_zip.exr"}) {
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("stamps/") + name);
    EXPECT_EQ(measure_seam(read_stamp(path)).verdict, SeamVerdict::padded) << name;
  }
}

TEST(Seam, IsMeasuredInEitherDirection) {
  // Steps of 1 within, 9 across in x; none in y.
  const StampImage ramp = image_of(10, 4, 1, [](int x, int, int) { return static_cast<float>(x); });
  const Seam seam = measure_seam(ramp);
  EXPECT_DOUBLE_EQ(seam.x.over_interior, 9);
  EXPECT_DOUBLE_EQ(seam.x.over_beside, 9);
  EXPECT_EQ(seam.y.over_interior, 0);
  EXPECT_EQ(seam.border_spread, 1);
  EXPECT_EQ(seam.verdict, SeamVerdict::does_not_tile);
  const StampImage turned = image_of(4, 10, 1, [](int, int y, int) { return static_cast<float>(y); });
  EXPECT_DOUBLE_EQ(measure_seam(turned).y.over_interior, 9);
  EXPECT_EQ(measure_seam(turned).x.over_interior, 0);
}

TEST(Seam, IsThatOfTheWorstChannel) {
  const auto wave = [](int x, int y, int channel) {
    const float tile =
        static_cast<float>(std::sin(x * std::numbers::pi / 8) + std::sin(y * std::numbers::pi / 8));
    return channel == 2 ? static_cast<float>(x) : tile;
  };
  const StampImage image = image_of(16, 16, 3, wave);
  EXPECT_DOUBLE_EQ(measure_seam(image).x.over_interior, 15);
  EXPECT_EQ(measure_seam(image).verdict, SeamVerdict::does_not_tile);
  const StampImage tile = image_of(16, 16, 1, wave);
  EXPECT_EQ(measure_seam(tile).verdict, SeamVerdict::tiles);
}

TEST(Seam, OfAnImageWithoutStepsIsPadding) {
  for (const auto& [width, height] : {std::pair{8, 8}, {1, 1}, {1, 5}}) {
    const Seam seam = measure_seam(image_of(width, height, 1, [](int, int, int) { return 3.0f; }));
    EXPECT_EQ(seam.x.over_interior, 0);
    EXPECT_EQ(seam.verdict, SeamVerdict::padded);
  }
}

}  // namespace
}  // namespace burin
