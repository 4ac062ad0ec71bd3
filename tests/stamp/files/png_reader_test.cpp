// Tests PNG stamps as various programs write them.
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include "stamp/files/stamp_files.h"

namespace burin::test {
namespace {

using PngFiles = StampFiles;

TEST_F(PngFiles, ReadsThePngNumbersWhateverTheFileSaysOfColour) {
  const std::string grey = bytes_of<std::uint16_t>({0, 0x3433, 0x6766, 0xffff});  // stored as they lie here
  const std::vector<float> plain = read_stamp(write_png(4, 1, 16, PNG_COLOR_TYPE_GRAY, grey)).texels;
  EXPECT_FLOAT_EQ(plain[1], 0x3334 / 65535.0f);
  const std::vector<std::function<void(png_structp, png_infop)>> chunks = {
      [](png_structp png, png_infop info) { png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL); },
      [](png_structp png, png_infop info) { png_set_gAMA(png, info, 1); },
      [](png_structp png, png_infop info) { png_set_oFFs(png, info, 18, 9, PNG_OFFSET_PIXEL); },
      [](png_structp png, png_infop info) {
        png_color_16 transparent{};
        transparent.gray = 0x3334;
        png_set_tRNS(png, info, nullptr, 1, &transparent);
      },
      [](png_structp png, png_infop info) {
        png_color_8 bits{};
        bits.gray = 5;
        png_set_sBIT(png, info, &bits);
      }};
  for (const auto& chunk : chunks) {
    const StampImage image = read_stamp(write_png(4, 1, 16, PNG_COLOR_TYPE_GRAY, grey, chunk));
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ(image.channels, 1);
    EXPECT_EQ(image.texels, plain);
  }
}

TEST_F(PngFiles, ReadsSmallNumbersPalettesAndAlphaOfPng) {
  const std::vector<float> bits = read_stamp(write_png(4, 1, 2, PNG_COLOR_TYPE_GRAY, "\x1b")).texels;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(bits[i], static_cast<float>(i) / 3);
  const auto palette = [](png_structp png, png_infop info) {
    const png_color colours[2] = {{51, 102, 153}, {255, 0, 204}};
    png_set_PLTE(png, info, colours, 2);
  };
  const StampImage image =
      read_stamp(write_png(2, 1, 8, PNG_COLOR_TYPE_PALETTE, std::string("\0\x01", 2), palette));
  expect_near(image.texels, (std::vector<float>{0.2f, 0.4f, 0.6f, 1, 0, 0.8f}));
  StampFile file;
  const StampImage grey =
      read_stamp(write_png(2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, std::string("\x33\0\x66\x80", 4)), {}, &file);
  expect_near(grey.texels, (std::vector<float>{0.2f, 0.4f}));
  EXPECT_EQ(file.unused, std::vector<std::string>{"A"});
}

TEST_F(PngFiles, TurnsAPngUpright) {
  const auto exif = [](png_structp png, png_infop info) {
    static png_byte block[] = "MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x03\0\0\0\0\0\0";
    png_set_eXIf_1(png, info, sizeof block - 1, block);
  };
  const StampImage image =
      read_stamp(write_png(3, 1, 8, PNG_COLOR_TYPE_GRAY, std::string("\0\x33\x66", 3), exif));
  expect_near(image.texels, (std::vector<float>{0.4f, 0.2f, 0}));
}

}  // namespace
}  // namespace burin::test
