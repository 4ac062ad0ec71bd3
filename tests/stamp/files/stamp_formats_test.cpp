// Tests the metadata of stamp files, besides their texels, as various programs write them.

#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>

#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

/// A file of the running test, and what read_stamp makes of it.
class StampFormats : public ::testing::Test {
 protected:
  fs::path path(const char* name) const { return folder_.path() / name; }

  std::string complaint(const fs::path& file, const StampOptions& options = {}) const {
    try {
      read_stamp(file, options);
    } catch (const FileError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find('\n'), what.npos) << what;
      return what.substr(file.string().size());
    }
    return "accepted";
  }

  /// Written by libtiff: `samples` of `bits` bits, one sample a texel unless `more` says otherwise.
  fs::path write_tiff(std::uint32_t width, std::uint32_t height, std::uint16_t bits, const std::string& bytes,
                      const std::function<void(TIFF*)>& more = {}) const {
    const fs::path file = path("a.tif");
    TIFF* tiff = TIFFOpen(file.c_str(), "w");
    write_directory(tiff, width, height, bits, bytes, more);
    TIFFClose(tiff);
    return file;
  }

  static void write_directory(TIFF* tiff, std::uint32_t width, std::uint32_t height, std::uint16_t bits,
                              const std::string& bytes, const std::function<void(TIFF*)>& more = {}) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, height);
    if (more) more(tiff);
    std::string copy = bytes;
    if (TIFFIsTiled(tiff))
      TIFFWriteEncodedTile(tiff, 0, copy.data(), static_cast<tmsize_t>(copy.size()));
    else
      TIFFWriteEncodedStrip(tiff, 0, copy.data(), static_cast<tmsize_t>(copy.size()));
    TIFFWriteDirectory(tiff);
  }

  /// Written by libpng: rows of bytes as the header has them; `more` sets other chunks.
  fs::path write_png(std::uint32_t width, std::uint32_t height, int bits, int colour, std::string bytes,
                     const std::function<void(png_structp, png_infop)>& more = {}) const {
    const fs::path file = path("a.png");
    std::FILE* out = std::fopen(file.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, out);
    png_set_IHDR(png, info, width, height, bits, colour, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (more) more(png, info);
    png_write_info(png, info);
    const std::size_t row = png_get_rowbytes(png, info);
    for (std::size_t y = 0; y < height; ++y)
      png_write_row(png, reinterpret_cast<png_bytep>(bytes.data() + y * row));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(out);
    return file;
  }

  test::TemporaryFolder folder_;
};

/// Equal but for the rounding of fractions.
void expect_near(const std::vector<float>& found, const std::vector<float>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6f) << i;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

void white_is_zero(TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE); }

TEST_F(StampFormats, HasBlackAsZeroAtEveryDepth) {
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

TEST_F(StampFormats, HasBlackAsZeroInTilesToo) {
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

TEST_F(StampFormats, LeavesOutWhereATiffStandsOnAPage) {
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
TEST_F(StampFormats, RefusesATiffWhoseTexelsDoNotDecode) {
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

TEST_F(StampFormats, TurnsATiffUpright) {
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

TEST_F(StampFormats, FillsWhatHoldsNoDataWhereAskedElseRefusesIt) {
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

TEST_F(StampFormats, FillsWholeNumbersThatHoldNoData) {
  const fs::path words =
      write_tiff(3, 1, 16, bytes_of<std::uint16_t>({100, 32767, 300}), no_data("32767", false));
  EXPECT_FLOAT_EQ(read_stamp(words, {.clean = true}).texels[1], 200 / 65535.0f);
  const fs::path bytes = write_tiff(3, 1, 8, "\x0a\xff\x1e", no_data("255", false));
  EXPECT_FLOAT_EQ(read_stamp(bytes, {.clean = true}).texels[1], 20 / 255.0f);
}

TEST_F(StampFormats, ReadsWholeNumbersOf32BitsAndWithASign) {
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

TEST_F(StampFormats, LeavesOutMasksAndSmallerCopiesOfATiff) {
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

TEST_F(StampFormats, RefusesColoursThatAreNoNumbers) {
  const auto lab = [](TIFF* tiff) {
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_CIELAB);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
  };
  EXPECT_EQ(complaint(write_tiff(1, 1, 8, "abc", lab)),
            ": holds colours other than grey and RGB; a stamp is made of numbers");
}

TEST_F(StampFormats, ReadsThePngNumbersWhateverTheFileSaysOfColour) {
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

TEST_F(StampFormats, ReadsSmallNumbersPalettesAndAlphaOfPng) {
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

TEST_F(StampFormats, TurnsAPngUpright) {
  const auto exif = [](png_structp png, png_infop info) {
    static png_byte block[] = "MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x03\0\0\0\0\0\0";
    png_set_eXIf_1(png, info, sizeof block - 1, block);
  };
  const StampImage image =
      read_stamp(write_png(3, 1, 8, PNG_COLOR_TYPE_GRAY, std::string("\0\x33\x66", 3), exif));
  expect_near(image.texels, (std::vector<float>{0.4f, 0.2f, 0}));
}

TEST_F(StampFormats, SaysOneLineOfDamagedFilesAndNothingBesides) {
  const std::string png = read_file(write_png(64, 64, 16, PNG_COLOR_TYPE_GRAY, std::string(8192, 'x')));
  const std::string tiff = read_file(write_tiff(64, 64, 8, std::string(4096, 'x')));
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const std::string& whole : {png, tiff})
    for (std::size_t at = 8; at < std::min<std::size_t>(whole.size(), 200); ++at)
      for (const char c : {'\0', '\x7f', '\xff'}) {
        std::string damaged = whole;
        damaged[at] = c;
        write_file_whole(path("damaged"), [&](std::ostream& out) { out << damaged; });
        complaint(path("damaged"));
        write_file_whole(path("cut"), [&](std::ostream& out) { out << whole.substr(0, at); });
        complaint(path("cut"));
      }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  std::string broken = png;
  broken[broken.find("IDAT") + 8] ^= 1;
  write_file_whole(path("broken.png"), [&](std::ostream& out) { out << broken; });
  EXPECT_TRUE(complaint(path("broken.png")).starts_with(": is damaged: IDAT: "));
}

/// Writes by OpenImageIO.
template <class Value>
void write_image(const fs::path& file, const OIIO::ImageSpec& spec, const std::vector<Value>& values) {
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output && output->open(file.string(), spec)) << OIIO::geterror();
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<Value>::value, values.data())) << output->geterror();
  output->close();
}

TEST_F(StampFormats, TurnsAJpegUpright) {
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

TEST_F(StampFormats, RefusesEveryTruncationOfEveryFormat) {
  std::vector<std::uint8_t> values(64 * 64);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i * i % 251);
  OIIO::ImageSpec spec(64, 64, 1, OIIO::TypeUInt8);
  for (const char* name : {"a.jpg", "a.tif", "a.png"}) {
    write_image(path(name), spec, values);
    const std::string whole = read_file(path(name));
    EXPECT_EQ(complaint(path(name)), "accepted");
    for (std::size_t size = 1; size < whole.size(); size += 1 + whole.size() / 100) {
      write_file_whole(path("cut"), [&](std::ostream& out) { out << whole.substr(0, size); });
      EXPECT_NE(complaint(path("cut")), "accepted") << name << " " << size << " of " << whole.size();
    }
  }
  // The directory of this file precedes the texels.
  const std::string bytes(64, 'x');
  const auto directory_first = [](TIFF* tiff) { TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 8); };
  const std::string tiff = read_file(write_tiff(8, 8, 8, bytes, directory_first));
  std::string early = "II\x2a\0\x08\0\0\0"s;
  const std::size_t at = static_cast<unsigned char>(tiff[4]) + 256u * static_cast<unsigned char>(tiff[5]);
  early += tiff.substr(at);
  const std::size_t texels = early.size();
  for (std::size_t entry = 10; entry + 12 < early.size(); entry += 12)
    if (early.compare(entry, 2, "\x11\x01") == 0) early[entry + 8] = static_cast<char>(texels);
  ASSERT_LT(texels, 256u);
  for (const std::size_t kept : {64u, 63u, 0u}) {
    write_file_whole(path("early.tif"), [&](std::ostream& out) { out << early << bytes.substr(0, kept); });
    EXPECT_EQ(complaint(path("early.tif")),
              kept == 64 ? "accepted" : ": is cut off: texels lie beyond its end");
  }
}

/// OpenEXR would ask for gigabytes before it reads a texel.
TEST_F(StampFormats, AsksForNoMoreThanAnExrHeaderMay) {
  OIIO::ImageSpec spec(1, 8, 1, OIIO::TypeFloat);
  spec.attribute("compression", "none");
  const auto with = [&](const std::string& member, std::size_t at, std::uint32_t number) {
    write_image(path("a.exr"), spec, std::vector<float>(256));
    std::string bytes = read_file(path("a.exr"));
    const std::size_t begin = bytes.find(member);
    EXPECT_NE(begin, bytes.npos) << member;
    std::memcpy(bytes.data() + begin + member.size() + 4 + at, &number, 4);
    write_file_whole(path("a.exr"), [&](std::ostream& out) { out << bytes; });
    return complaint(path("a.exr"));
  };
  const std::string window = "dataWindow\0box2i\0"s, tiles = "tiles\0tiledesc\0"s;
  EXPECT_EQ(with(window, 12, 7), "accepted");
  EXPECT_TRUE(with(window, 12, 2000000000).starts_with(": is too large: 1 x 2000000001 texels"));
  EXPECT_TRUE(with(window, 12, 100000000).starts_with(": asks for 400 MB of memory in "));
  EXPECT_EQ(with(window, 12, 15000000), ": is cut off: it tells of more chunks than it has room for");
  EXPECT_TRUE(with(window, 8, 1000000000).starts_with(": is too large: 1000000001 x 8 texels"));
  spec.attribute("compression", "piz");
  EXPECT_TRUE(with(window, 8, 999999).starts_with(": asks for 128 MB of memory in "));
  constexpr auto size_before = static_cast<std::size_t>(-4);
  for (const std::string& member : {"lineOrder\0lineOrder\0"s, "channels\0chlist\0"s})
    EXPECT_EQ(with(member, size_before, 24), ": is damaged: its header has an attribute of a wrong size");
  EXPECT_EQ(with("channels\0chlist\0"s, size_before, 2000000000), ": is damaged: its header has no end");
  spec = OIIO::ImageSpec(16, 16, 1, OIIO::TypeFloat);
  spec.tile_width = spec.tile_height = 16;
  EXPECT_EQ(with(tiles, 0, 16), "accepted");
  EXPECT_TRUE(with(tiles, 0, 4000000000).starts_with(": is too large: 4000000000 x 16 texels"));
  const std::string whole = read_file(path("a.exr"));
  for (const std::size_t size : {7u, 40u, 100u}) {
    write_file_whole(path("cut.exr"), [&](std::ostream& out) { out << whole.substr(0, size); });
    EXPECT_EQ(complaint(path("cut.exr")), ": is damaged: its header has no end");
  }
}

TEST_F(StampFormats, ReadsLayersAndChannelsOfExrByName) {
  OIIO::ImageSpec spec(1, 1, 7, OIIO::TypeFloat);
  spec.channelnames = {"disp.B", "disp.G", "disp.R", "mask.Y", "n.X", "n.Y", "n.Z"};
  const std::vector<float> values = {3, 2, 1, 4, 5, 6, 7};
  write_image(path("layers.exr"), spec, values);
  const auto texels = [&](const char* layer, const char* channel) {
    return read_stamp(path("layers.exr"), {.layer = layer, .channel = channel}).texels;
  };
  EXPECT_EQ(texels("disp", ""), (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(texels("mask", ""), (std::vector<float>{4}));
  EXPECT_EQ(texels("n", ""), (std::vector<float>{5, 6, 7}));
  EXPECT_EQ(texels("", "n.Z"), (std::vector<float>{7}));
  EXPECT_EQ(texels("disp", "G"), (std::vector<float>{2}));
  EXPECT_EQ(texels("", "n.Z,disp.R,mask.Y"), (std::vector<float>{7, 1, 4}));
  EXPECT_EQ(complaint(path("layers.exr")),
            ": holds several layers, of which one must be chosen by its name: 'disp', 'mask', 'n'");
}

TEST_F(StampFormats, HasPartsOfExrAsLayers) {
  std::vector<OIIO::ImageSpec> parts(2, OIIO::ImageSpec(2, 1, 3, OIIO::TypeFloat));
  parts[1] = OIIO::ImageSpec(1, 1, 1, OIIO::TypeFloat);
  parts[1].full_width = 2;  // all parts have one display window
  parts[0].attribute("name", "disp");
  parts[1].attribute("name", "mask");
  const auto output = OIIO::ImageOutput::create("a.exr");
  const std::string file = path("parts.exr").string();
  const std::vector<float> values = {1, 2, 3, 4, 5, 6}, mask = {7}, shown = {7, 0};
  ASSERT_TRUE(output->open(file, 2, parts.data())) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
  ASSERT_TRUE(output->open(file, parts[1], OIIO::ImageOutput::AppendSubimage));
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, mask.data()));
  output->close();
  EXPECT_EQ(read_stamp(file, {.layer = "disp"}).texels, values);
  EXPECT_EQ(read_stamp(file, {.layer = "mask"}).texels, shown);
  EXPECT_EQ(complaint(file),
            ": holds several layers, of which one must be chosen by its name: 'disp', 'mask'");
}

TEST_F(StampFormats, MovesTheZeroOfAllChannelsButAlpha) {
  write_image(path("rgba.exr"), OIIO::ImageSpec(1, 1, 4, OIIO::TypeFloat),
              std::vector<float>{0.5f, 0.75f, 0, 1});
  const StampImage image = read_stamp(path("rgba.exr"), {.zero = 0.5f});
  expect_near(image.texels, (std::vector<float>{0, 0.25f, -0.5f, 1}));
  EXPECT_EQ(image.maximum, 0);
}

TEST_F(StampFormats, RefusesLargePicturesInSmallFiles) {
  // A header that tells 5000 x 5000 texels before a few bytes of data.
  std::string png = read_file(write_png(1, 1, 8, PNG_COLOR_TYPE_GRAY, "x"));
  const auto set_size = [](std::string& bytes, std::size_t at, std::size_t step, int value) {
    bytes[at] = static_cast<char>(value >> 8);
    bytes[at + step] = static_cast<char>(value & 255);
  };
  OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeUInt8);
  write_image(path("a.jpg"), spec, std::vector<std::uint8_t>(192));
  std::string jpeg = read_file(path("a.jpg"));
  const std::size_t frame = jpeg.find("\xff\xc0");
  ASSERT_NE(frame, jpeg.npos);
  for (const int at : {5, 7}) set_size(jpeg, frame + static_cast<std::size_t>(at), 1, 5000);
  write_file_whole(path("large.jpg"), [&](std::ostream& out) { out << jpeg; });
  EXPECT_EQ(complaint(path("large.jpg")), ": asks for 300 MB of memory in " + std::to_string(jpeg.size()) +
                                              " bytes; a stamp may ask for 64 MB, or 4000 times its size");
  spec = OIIO::ImageSpec(2, 2, 1, OIIO::TypeFloat);
  spec.full_width = spec.full_height = 5000;
  write_image(path("window.exr"), spec, std::vector<float>(4));
  EXPECT_TRUE(complaint(path("window.exr")).starts_with(": asks for 100 MB of memory in "));
  spec.full_width = 12000;
  spec.full_height = 12000;
  write_image(path("window.exr"), spec, std::vector<float>(4));
  EXPECT_EQ(complaint(path("window.exr")),
            ": is too large: 12000 x 12000 texels of 1 channel; a stamp holds at most 2^27 values");
}

TEST_F(StampFormats, TellsTheFormatByTheContentAndRefusesDevices) {
  const fs::path png = write_png(1, 1, 8, PNG_COLOR_TYPE_GRAY, "\x33");
  fs::rename(png, path("a.exr"));
  expect_near(read_stamp(path("a.exr")).texels, std::vector<float>{0.2f});
  if (!fs::exists("/dev/zero")) return;
  EXPECT_EQ(complaint("/dev/zero"), ": is not a file");
}

}  // namespace
}  // namespace burin
