#pragma once
#include <burin/stamp/wrap.h>

#include <utility>
#include <vector>

namespace burin {

/// An image of floating-point texels, rows from the top, channels interleaved, all finite.
struct StampImage {
  int width = 0, height = 0, channels = 0;
  std::vector<float> texels;                              ///< width * height * channels
  float minimum = 0, maximum = 0;                         ///< of the first channel
  Wrap wrap_u = Wrap::periodic, wrap_v = Wrap::periodic;  ///< never unknown
};

/// The least and the greatest value of a channel.
std::pair<float, float> channel_range(const StampImage& image, int channel);

/// Sets minimum and maximum from the texels.
void set_range(StampImage& image);

/// A bilinear sample of a channel. u runs to the right and v down; (0, 0) and (1, 1) are the image's corners,
/// and texel centres are at (i + 0.5) / width. wrap_u and wrap_v define the values outside the image. Returns
/// NaN if u or v is not finite. Any thread.
float sample_bilinear(const StampImage& image, int channel, float u, float v);

}  // namespace burin
