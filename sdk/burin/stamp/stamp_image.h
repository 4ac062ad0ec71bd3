#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace burin {

/// An image of floating-point texels, rows from the top, channels interleaved, all finite.
struct StampImage {
  int width = 0, height = 0, channels = 0;
  std::vector<float> texels;       ///< width * height * channels
  float minimum = 0, maximum = 0;  ///< over the first channel
};

/// Sets minimum and maximum.
void set_range(StampImage& image);

/// Reads the display window of the first part of an EXR image of half or float texels; what its data window
/// leaves out is 0. Throws FileError: not readable, truncated, whole-number or deep texels, another format,
/// more than 2^28 values, or a value that is not finite (named by channel, x, y).
StampImage read_stamp(const std::filesystem::path& path);

/// Bilinear sample of a channel with period 1 in u (right) and v (down); texel centres at (i + 0.5) / width.
/// NaN where u or v is not finite. Any thread.
float sample_bilinear(const StampImage& image, int channel, float u, float v);

}  // namespace burin
