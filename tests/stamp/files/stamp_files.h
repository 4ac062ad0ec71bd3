#pragma once
#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "support/shared_data.h"

namespace burin::test {

namespace fs = std::filesystem;

/// A file of the running test, and what read_stamp makes of it.
class StampFiles : public ::testing::Test {
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

  TemporaryFolder folder_;
};

/// Equal but for the rounding of fractions.
inline void expect_near(const std::vector<float>& found, const std::vector<float>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6f) << i;
}
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}
/// Writes by OpenImageIO.
template <class Value>
void write_image(const fs::path& file, const OIIO::ImageSpec& spec, const std::vector<Value>& values) {
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output && output->open(file.string(), spec)) << OIIO::geterror();
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<Value>::value, values.data())) << output->geterror();
  output->close();
}

}  // namespace burin::test
