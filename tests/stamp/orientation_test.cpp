#include <burin/stamp/orientation.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "images.h"

namespace burin {
namespace {

using namespace std::string_literals;

TEST(SetUpright, TurnsAsExifTells) {
  // 0 1 2   The letters of EXIF's own picture: where the stored rows begin and where they run to.
  // 3 4 5
  const std::array<std::vector<float>, 8> upright = {{{0, 1, 2, 3, 4, 5},
                                                      {2, 1, 0, 5, 4, 3},
                                                      {5, 4, 3, 2, 1, 0},
                                                      {3, 4, 5, 0, 1, 2},
                                                      {0, 3, 1, 4, 2, 5},
                                                      {3, 0, 4, 1, 5, 2},
                                                      {5, 2, 4, 1, 3, 0},
                                                      {2, 5, 1, 4, 0, 3}}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    SCOPED_TRACE(orientation);
    StampImage image =
        test::image_of(3, 2, 3, [](int x, int y, int c) { return static_cast<float>(3 * y + x + 10 * c); });
    apply_orientation(image, orientation);
    EXPECT_EQ(image.width, orientation < 5 ? 3 : 2);
    EXPECT_EQ(image.height, orientation < 5 ? 2 : 3);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(image.texels[3 * i + c],
                  upright[static_cast<std::size_t>(orientation - 1)][i] + 10 * static_cast<float>(c));
  }
}

TEST(SetUpright, LeavesWhatItDoesNotKnow) {
  const StampImage image = test::image_of(3, 2, 1, [](int x, int, int) { return static_cast<float>(x); });
  for (const int orientation : {-1, 0, 9, 1 << 20}) {
    StampImage turned = image;
    apply_orientation(turned, orientation);
    EXPECT_EQ(turned.texels, image.texels);
  }
}

TEST(ExifOrientation, ReadsEitherByteOrderAndAnyDamage) {
  const std::string little =
      "II\x2a\0\x08\0\0\0\x02\0\x0f\x01\x02\0\x01\0\0\0xxxx\x12\x01\x03\0\x01\0\0\0\x06\0\0\0"s;
  const std::string big = "MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x08\0\0"s;
  EXPECT_EQ(exif_orientation(little), 6);
  EXPECT_EQ(exif_orientation("Exif\0\0"s + little), 6);
  EXPECT_EQ(exif_orientation(big), 8);
  EXPECT_EQ(exif_orientation(""), 1);
  for (std::size_t size = 0; size < little.size() - 3; ++size) {
    const int found = exif_orientation(little.substr(0, size));
    EXPECT_TRUE(found == 0 || found == 1) << size;
  }
  EXPECT_EQ(exif_orientation("II\x2a\0\xff\xff\xff\xff"s), 1);
}

}  // namespace
}  // namespace burin
