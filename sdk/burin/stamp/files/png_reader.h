#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace burin {

/// A PNG as numbers: of what a file says of colour (sRGB, gamma, profiles), of transparency by a colour and
/// of the place on a page nothing is applied.
struct PngNumbers {
  std::uint32_t width = 0, height = 0, channels = 0;  ///< 1 grey, 2 with alpha, 3 colours, 4 with alpha
  bool words = false;                                 ///< numbers of 16 bits, else of 8
  std::vector<float> texels;                          ///< 0..1: fractions of the greatest number
  int orientation = 1;                                ///< of its EXIF
};

/// Reads a PNG file: grey of 1, 2 and 4 bits as fractions of their greatest number, a palette's colours.
/// Throws FileError: damaged, or too large (image_limits.h).
PngNumbers read_png_numbers(const std::filesystem::path& path);

}  // namespace burin
