// Tests JPEG stamps.
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include "stamp/files/stamp_files.h"

namespace burin::test {
namespace {

using JpegFiles = StampFiles;

TEST_F(JpegFiles, TurnsAJpegUpright) {
  std::vector<std::uint8_t> values(32 * 16);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i % 32 * 8);
  OIIO::ImageSpec spec(32, 16, 1, OIIO::TypeUInt8);
  spec.attribute("CompressionQuality", 100);
  spec.attribute("Orientation", 8);
  write_image(path("a.jpg"), spec, values);
  const StampImage image = read_stamp(path("a.jpg"));
  EXPECT_EQ(image.width, 16);
  EXPECT_EQ(image.height, 32);
  for (std::size_t y = 0; y < 32; ++y)
    EXPECT_NEAR(image.texels[y * 16 + 7], static_cast<float>(8 * (31 - y)) / 255, 0.02f) << y;
}

}  // namespace
}  // namespace burin::test
