#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace burin {

/// The content of a PNG file as plain numbers. Chunks about colour (sRGB, gamma, profiles), transparent
/// colours and the position on a page are not applied.
struct PngImage {
  std::uint32_t width = 0, height = 0, channels = 0;  ///< 1 grey, 2 with alpha, 3 colours, 4 with alpha
  bool words = false;                                 ///< whether numbers have 16 bits, else 8
  std::vector<float> texels;                          ///< 0..1: fractions of the greatest number
  int orientation = 1;                                ///< orientation stored in the EXIF chunk
};

/// Reads a PNG file. Grey of 1, 2 and 4 bits becomes fractions of the greatest number; a palette is replaced
/// by its colours. Throws FileError if the file is damaged or too large (image_limits.h).
PngImage read_png_numbers(const std::filesystem::path& path);

}  // namespace burin
