#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Facts about the first image of a TIFF file that OpenImageIO does not return.
struct TiffInfo {
  bool white_is_zero = false;  ///< 0 means white: PhotometricInterpretation 0
  bool numbers = true;         ///< grey or RGB, not another colour space (CIE Lab, CMYK)
  unsigned odd_bits = 0;       ///< of whole numbers of other than 1, 2, 4, 8, 16 or 32 bits, else 0
  std::string misread;         ///< texels that OpenImageIO misreads, in words; empty if it reads them
  bool untold_bits = false;    ///< texels are bits since no tag tells more, which OpenImageIO takes for bytes
  double greatest = 1;         ///< the largest whole number, which becomes 1; 1 for floating point
  std::optional<double> no_data;  ///< the number that marks texels without data (GDAL's tag)
  bool cut_off = false;           ///< texels of the first image lie beyond the end of the file
  bool more_images = false;       ///< the file has images besides the first, its masks and its smaller copies
};

/// Reads the facts. Throws FileError if the file is not readable as a TIFF.
TiffInfo read_tiff_facts(const std::filesystem::path& path, std::uintmax_t file_bytes);

/// Throws FileError if some texels of the first image cannot be decoded, for which OpenImageIO gives zeros
/// without a word. The image's size must have been checked.
void expect_texels_that_decode(const std::filesystem::path& path);

/// The bits of an image of one channel in strips, row by row, 0 or 1. Throws FileError for rows that cannot
/// be decoded. The image's size must have been checked.
std::vector<float> read_bits(const std::filesystem::path& path);

}  // namespace burin
