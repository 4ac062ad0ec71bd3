#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace burin {

/// An image of floating-point texels, rows from the top, channels interleaved, all finite.
struct StampImage {
  int width = 0, height = 0, channels = 0;
  std::vector<float> texels;           ///< width * height * channels
  float minimum = 0, maximum = 0;      ///< over the first channel
};

/// Reads an EXR image of half or float texels. Throws FileError: unreadable, whole-number texels, empty,
/// or a texel that is not finite (named by channel, x, y).
StampImage read_stamp(const std::filesystem::path& path);

/// Bilinear sample of a channel with period 1 in u (right) and v (down); texel centres at (i + 0.5) / width.
/// u and v finite.
float sample_bilinear(const StampImage& image, int channel, float u, float v);

}  // namespace burin
