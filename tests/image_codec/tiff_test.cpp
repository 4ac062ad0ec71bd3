// Tests TIFF stamps as various programs write them.
#include <burin/base/file.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "stamp/files/stamp_files.h"

namespace burin::test {
namespace {

using TiffFiles = StampFiles;

void white_is_zero(TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE); }

TEST_F(TiffFiles, HasBlackAsZeroAtEveryDepth) {
  const auto texels = [&](std::uint16_t bits, const std::string& bytes) {
    return read_stamp(write_tiff(4, 1, bits, bytes, white_is_zero)).texels;
  };
  EXPECT_EQ(texels(1, "\x50"), (std::vector<float>{1, 0, 1, 0}));
  const std::vector<float> quarters = texels(2, "\x1b");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(quarters[i], 1 - static_cast<float>(i) / 3) << i;
  const std::vector<float> nibbles = texels(4, "\x01\x2f");
  EXPECT_FLOAT_EQ(nibbles[1], 14 / 15.0f);
  EXPECT_FLOAT_EQ(nibbles[3], 0);
  EXPECT_FLOAT_EQ(texels(8, std::string("\0\x33\x66\xff", 4))[1], 0.8f);
  EXPECT_FLOAT_EQ(texels(16, bytes_of<std::uint16_t>({0, 13107, 1, 65535}))[1], 0.8f);
  const auto floats = [](TIFF* tiff) {
    white_is_zero(tiff);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  };
  const fs::path file = write_tiff(4, 1, 32, bytes_of<float>({0, 0.25f, -1, 3}), floats);
  expect_near(read_stamp(file).texels, (std::vector<float>{1, 0.75f, 2, -2}));
}

TEST_F(TiffFiles, HasFractionsOfTheLargestNumberOfAnyBits) {
  for (const unsigned bits : {6U, 10U, 12U, 14U})
    for (const bool inverted : {false, true}) {
      const unsigned most = (1U << bits) - 1;
      std::vector<unsigned> numbers;
      for (unsigned i = 0; i < 64; ++i) numbers.push_back(i * most / 63);
      std::string bytes;
      unsigned held = 0, count = 0;
      for (const unsigned number : numbers)
        for (unsigned bit = bits; bit-- > 0;) {
          held = held << 1 | (number >> bit & 1U);
          if (++count % 8 == 0) bytes += static_cast<char>(held & 255U);
        }
      const auto setup = [&](TIFF* tiff) {
        if (inverted) white_is_zero(tiff);
      };
      const std::vector<float> texels =
          read_stamp(write_tiff(64, 1, static_cast<std::uint16_t>(bits), bytes, setup)).texels;
      for (std::size_t i = 0; i < 64; ++i) {
        const float share = static_cast<float>(numbers[i]) / static_cast<float>(most);
        EXPECT_NEAR(texels[i], inverted ? 1 - share : share, 1e-7) << bits << " bits, texel " << i;
      }
    }
}

/// A TIFF of bits in one strip that relies on the default of BitsPerSample, 1: 12 texels a row, 2 bytes each.
std::string tiff_of_untold_bits(std::uint16_t meaning, std::uint16_t channels, const std::string& rows) {
  const auto size = static_cast<std::uint32_t>(rows.size());
  const std::vector<std::array<std::uint32_t, 2>> tags = {{TIFFTAG_IMAGEWIDTH, 12},
                                                          {TIFFTAG_IMAGELENGTH, size / 2},
                                                          {TIFFTAG_PHOTOMETRIC, meaning},
                                                          {TIFFTAG_STRIPOFFSETS, 8 + 2 + 7 * 12 + 4},
                                                          {TIFFTAG_SAMPLESPERPIXEL, channels},
                                                          {TIFFTAG_ROWSPERSTRIP, size / 2},
                                                          {TIFFTAG_STRIPBYTECOUNTS, size}};
  constexpr std::uint16_t long_number = 4;
  std::string bytes = std::string("II*\0", 4) + bytes_of<std::uint32_t>({8}) + bytes_of<std::uint16_t>({7});
  for (const auto& [tag, value] : tags)
    bytes += bytes_of<std::uint16_t>({static_cast<std::uint16_t>(tag), long_number}) +
             bytes_of<std::uint32_t>({1, value});
  return bytes + bytes_of<std::uint32_t>({0}) + rows;
}

TEST_F(TiffFiles, ReadsBitsWhoseNumberIsNotTold) {
  const auto file = [&](std::uint16_t meaning, std::uint16_t channels) {
    const std::string bytes = tiff_of_untold_bits(meaning, channels, "\x50\xf0\x8f\x10");
    write_file_whole(path("bits.tif"), [&](std::ostream& out) { out << bytes; });
    return path("bits.tif");
  };
  const std::vector<float> black_is_zero = {0, 1, 0, 1, 0, 0, 0, 0, 1, 1, 1, 1,
                                            1, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 1};
  EXPECT_EQ(read_stamp(file(PHOTOMETRIC_MINISBLACK, 1)).texels, black_is_zero);
  std::vector<float> inverted = black_is_zero;
  for (float& texel : inverted) texel = 1 - texel;
  EXPECT_EQ(read_stamp(file(PHOTOMETRIC_MINISWHITE, 1)).texels, inverted);
  EXPECT_EQ(complaint(file(PHOTOMETRIC_RGB, 3)),
            ": holds bits in tiles or several channels without the tag BitsPerSample, which is not read");
}

TEST_F(TiffFiles, HasBlackAsZeroInTilesToo) {
  const auto tiled = [](TIFF* tiff) {
    white_is_zero(tiff);
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
  };
  const std::string bytes(256, '\x33');
  expect_near(read_stamp(write_tiff(16, 16, 8, bytes, tiled)).texels, std::vector<float>(256, 0.8f));
  const std::string words = bytes_of(std::vector<std::uint16_t>(256, 13107));
  const std::vector<float> texels = read_stamp(write_tiff(16, 16, 16, words, tiled)).texels;
  for (const float texel : texels) ASSERT_FLOAT_EQ(texel, 0.8f);
}

TEST_F(TiffFiles, LeavesOutWhereATiffStandsOnAPage) {
  const auto offset = [](TIFF* tiff) {
    TIFFSetField(tiff, TIFFTAG_XPOSITION, 2.0);
    TIFFSetField(tiff, TIFFTAG_YPOSITION, 1.0);
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 1.0);
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 1.0);
  };
  const StampImage image = read_stamp(write_tiff(3, 2, 8, std::string("\0\x33\x66\x99\xcc\xff", 6), offset));
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  expect_near(image.texels, (std::vector<float>{0, 0.2f, 0.4f, 0.6f, 0.8f, 1}));
}

/// OpenImageIO gives zeros for strips that do not decode, and no error.
TEST_F(TiffFiles, RefusesATiffWhoseTexelsDoNotDecode) {
  const auto packed = [](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE); };
  std::string ramp;
  for (int i = 0; i < 256; ++i) ramp += static_cast<char>(i * i);
  const fs::path file = write_tiff(16, 16, 8, ramp, packed);
  EXPECT_EQ(complaint(file), "accepted");
  std::string bytes = read_file(file);
  constexpr std::size_t within_the_strip = 20;
  for (std::size_t i = 0; i < 30; ++i) bytes[within_the_strip + i] ^= 0x5a;
  write_file_whole(file, [&](std::ostream& out) { out << bytes; });
  EXPECT_EQ(complaint(file),
            ": is damaged, or compressed in a way that is not read: strip or tile 1 cannot be decoded");
}

TEST_F(TiffFiles, RefusesATiffWithoutTexels) {
  std::string bytes = tiff_of_untold_bits(PHOTOMETRIC_MINISBLACK, 1, "\x50\xf0");
  constexpr std::size_t byte_count = 8 + 2 + 6 * 12 + 8, offset = 8 + 2 + 3 * 12 + 8;
  for (const std::size_t at : {byte_count, offset}) bytes.replace(at, 4, 4, '\0');
  write_file_whole(path("empty.tif"), [&](std::ostream& out) { out << bytes; });
  EXPECT_EQ(complaint(path("empty.tif")), ": holds no texels");
}

TEST_F(TiffFiles, TurnsATiffUpright) {
  const auto turned = [](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_RIGHTTOP); };
  StampFile file;
  const StampImage image = read_stamp(write_tiff(3, 1, 8, std::string("\0\x33\x66", 3), turned), {}, &file);
  EXPECT_EQ(image.width, 1);
  EXPECT_EQ(image.height, 3);
  expect_near(image.texels, (std::vector<float>{0, 0.2f, 0.4f}));
  EXPECT_EQ(file.orientation, 6);
}

constexpr TIFFFieldInfo no_data_field = {TIFFTAG_GDAL_NODATA, -1, -1, TIFF_ASCII,
                                         FIELD_CUSTOM,        1,  0,  const_cast<char*>("GDALNoDataValue")};

/// Sets the no-data value of a TIFF of floats, as GDAL does.
std::function<void(TIFF*)> no_data(const char* text, bool floats = true) {
  return [text, floats](TIFF* tiff) {
    TIFFMergeFieldInfo(tiff, &no_data_field, 1);
    TIFFSetField(tiff, TIFFTAG_GDAL_NODATA, text);
    if (floats) TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  };
}

TEST_F(TiffFiles, FillsWhatHoldsNoDataWhereAskedElseRefusesIt) {
  const float lowest = std::numeric_limits<float>::lowest();
  for (const auto& [value, text] : {std::pair{-9999.0f, "-9999"},
                                    {lowest, "-3.4028234663852886e+38"},
                                    {lowest, "-3.40282e+38"},
                                    {0.1f, " 0.1 "},
                                    {1e-30f, "1e-30"}}) {
    const fs::path file = write_tiff(3, 1, 32, bytes_of<float>({2, value, 4}), no_data(text));
    EXPECT_TRUE(complaint(file).starts_with(":channel Y, x 1, y 0: the texel holds no data (")) << text;
    StampFile described;
    const StampImage image = read_stamp(file, {.clean = true}, &described);
    EXPECT_EQ(image.texels, (std::vector<float>{2, 3, 4})) << text;
    EXPECT_EQ(described.not_finite, 1u);
  }
  const fs::path other = write_tiff(2, 1, 32, bytes_of<float>({2, -9999}), no_data("-9998"));
  EXPECT_EQ(read_stamp(other).texels, (std::vector<float>{2, -9999}));
  const float none = std::numeric_limits<float>::quiet_NaN();
  const fs::path nan = write_tiff(2, 1, 32, bytes_of<float>({2, none}), no_data("nan"));
  EXPECT_EQ(read_stamp(nan, {.clean = true}).texels, (std::vector<float>{2, 2}));
}

TEST_F(TiffFiles, FillsWholeNumbersThatHoldNoData) {
  const fs::path words =
      write_tiff(3, 1, 16, bytes_of<std::uint16_t>({100, 32767, 300}), no_data("32767", false));
  EXPECT_FLOAT_EQ(read_stamp(words, {.clean = true}).texels[1], 200 / 65535.0f);
  const fs::path bytes = write_tiff(3, 1, 8, "\x0a\xff\x1e", no_data("255", false));
  EXPECT_FLOAT_EQ(read_stamp(bytes, {.clean = true}).texels[1], 20 / 255.0f);
}

/// The number is the file's, whatever white means, of as many bits as the file has.
TEST_F(TiffFiles, FillsNumbersOfAnyBitsThatHoldNoData) {
  const auto filled = [&](std::uint16_t bits, const std::string& bytes, const char* none, bool inverted) {
    const auto setup = [&](TIFF* tiff) {
      if (inverted) white_is_zero(tiff);
      no_data(none, false)(tiff);
    };
    return read_stamp(write_tiff(3, 1, bits, bytes, setup), {.clean = true}).texels;
  };
  // 100, 4095 and 300 in 12 bits; 256/4095 is nearly 4095/65535.
  EXPECT_NEAR(filled(12, std::string("\x06\x4f\xff\x12\xc0", 5), "4095", false)[1], 200 / 4095., 1e-6);
  EXPECT_NEAR(filled(12, std::string("\x06\x41\x00\x12\xc0", 5), "4095", false)[1], 256 / 4095., 1e-6);
  EXPECT_NEAR(filled(4, "\x3f\x90", "15", false)[1], 6 / 15., 1e-6);
  EXPECT_NEAR(filled(8, std::string("\x0a\0\x1e", 3), "0", true)[1], 1 - 20 / 255., 1e-6);
  EXPECT_NEAR(filled(8, std::string("\x0a\xff\x1e", 3), "0", true)[1], 0, 1e-6);
  EXPECT_NEAR(filled(16, bytes_of<std::uint16_t>({100, 7, 300}), "7", true)[1], 1 - 200 / 65535., 1e-6);
}

TEST_F(TiffFiles, ReadsWholeNumbersOf32BitsAndWithASign) {
  const auto is_signed = [](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_INT); };
  expect_near(read_stamp(write_tiff(3, 1, 32, bytes_of<std::uint32_t>({0, 858993459, 4294967295}))).texels,
              {0, 0.2f, 1});
  expect_near(
      read_stamp(write_tiff(3, 1, 32, bytes_of<std::int32_t>({-2147483647, 0, 429496730}), is_signed)).texels,
      {-1, 0, 0.2f});
  expect_near(
      read_stamp(write_tiff(3, 1, 16, bytes_of<std::int16_t>({-32767, 8192, 32767}), is_signed)).texels,
      {-1, 8192 / 32767.0f, 1});
  const auto lost = [&](TIFF* tiff) {
    is_signed(tiff);
    no_data("-32768", false)(tiff);
  };
  const fs::path file = write_tiff(3, 1, 16, bytes_of<std::int16_t>({100, -32768, 300}), lost);
  EXPECT_NE(complaint(file), "accepted");
  EXPECT_FLOAT_EQ(read_stamp(file, {.clean = true}).texels[1], 200 / 32767.0f);
}

void hold_doubles(TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP); }

TEST_F(TiffFiles, ReadsNumbersOf64BitsAsFloats) {
  const fs::path file = write_tiff(2, 2, 64, bytes_of<double>({-3, 1e-3, 1234.56789, 0.1}), hold_doubles);
  EXPECT_EQ(read_stamp(file).texels, (std::vector<float>{-3, 1e-3F, 1234.56789F, 0.1F}));
  const double lowest = std::numeric_limits<double>::lowest();
  const fs::path lacking = write_tiff(3, 2, 64, bytes_of<double>({2, lowest, 4, 2, 3, 4}), hold_doubles);
  EXPECT_NE(complaint(lacking), "accepted");
  EXPECT_EQ(read_stamp(lacking, {.clean = true}).texels, (std::vector<float>{2, 3, 4, 2, 3, 4}));
}

TEST_F(TiffFiles, RefusesBytesWithASign) {
  EXPECT_EQ(
      complaint(write_tiff(1, 1, 8, "a",
                           [](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_INT); })),
      ": channel 'Y' holds texels of type int8, which no stamp is made of");
}

// OpenImageIO 2.4 gives other numbers for them without a word.
TEST_F(TiffFiles, RefusesWhatTheLibraryMisreads) {
  EXPECT_EQ(complaint(write_tiff(4, 1, 24, std::string(12, '\x3f'), hold_doubles)),
            ": holds numbers of 24 bits, which is not read");
  EXPECT_EQ(complaint(write_tiff(4, 1, 24, std::string(12, '\x3f'))),
            ": holds numbers of 24 bits, which is not read");
  EXPECT_EQ(complaint(write_tiff(8, 1, 7, std::string(7, '\x3f'))),
            ": holds numbers of 7 bits, which is not read");
  const std::string wide = bytes_of<std::uint64_t>({1, 2, 3, 4});
  EXPECT_EQ(complaint(write_tiff(2, 2, 64, wide)), ": holds whole numbers of 64 bits, which is not read");
  EXPECT_EQ(complaint(write_tiff(
                2, 2, 64, wide,
                [](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_COMPLEXIEEEFP); })),
            ": holds complex numbers, which is not read");
  const std::string row = ": holds numbers of 64 bits in tiles, planes or a single row, which is not read";
  EXPECT_EQ(complaint(write_tiff(2, 1, 64, bytes_of<double>({1, 2}), hold_doubles)), row);
  EXPECT_EQ(complaint(write_tiff(16, 16, 64, bytes_of<double>(std::vector<double>(256, 0.5)),
                                 [](TIFF* tiff) {
                                   hold_doubles(tiff);
                                   TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
                                   TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
                                 })),
            row);
  const auto of_palette = [this](int step) {
    return complaint(write_tiff(4, 1, 8, "abcd", [step](TIFF* tiff) {
      std::vector<std::uint16_t> ramp(256);
      for (std::size_t i = 0; i < 256; ++i) ramp[i] = static_cast<std::uint16_t>(step * static_cast<int>(i));
      TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_PALETTE);
      TIFFSetField(tiff, TIFFTAG_COLORMAP, ramp.data(), ramp.data(), ramp.data());
    }));
  };
  EXPECT_EQ(of_palette(1), ": holds a palette of 8-bit instead of 16-bit colours, which is not read");
  EXPECT_EQ(of_palette(257), "accepted");
  EXPECT_EQ(of_palette(0), "accepted") << "all black";
}

TEST_F(TiffFiles, LeavesOutMasksAndSmallerCopiesOfATiff) {
  const fs::path file = path("overviews.tif");
  const auto kind = [](std::uint32_t number) {
    return [number](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, number); };
  };
  for (const std::uint32_t second : {FILETYPE_REDUCEDIMAGE, FILETYPE_MASK, 0}) {
    TIFF* tiff = TIFFOpen(file.c_str(), "w");
    write_directory(tiff, 2, 1, 8, "\x33\x66");
    write_directory(tiff, 1, 1, 8, "\x11", kind(second));
    TIFFClose(tiff);
    EXPECT_EQ(complaint(file), second ? "accepted" : ": holds several images; a stamp is one");
    if (second) {
      expect_near(read_stamp(file).texels, (std::vector<float>{0.2f, 0.4f}));
    }
  }
}

TEST_F(TiffFiles, RefusesColoursThatAreNoNumbers) {
  const auto lab = [](TIFF* tiff) {
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_CIELAB);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
  };
  EXPECT_EQ(complaint(write_tiff(1, 1, 8, "abc", lab)),
            ": holds colours other than grey and RGB; a stamp is made of numbers");
}

}  // namespace
}  // namespace burin::test
