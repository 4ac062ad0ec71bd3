#pragma once
#include <burin/stamp/stamp_image.h>

#include <functional>
#include <random>

namespace burin::test {

/// Texel centres are at (x + 0.5, y + 0.5).
inline StampImage image_of(int width, int height, int channels,
                           const std::function<float(int, int, int)>& value) {
  StampImage image{width, height, channels, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < channels; ++channel) image.texels.push_back(value(x, y, channel));
  return image;
}

inline StampImage random_image(int width, int height, int channels, std::mt19937& random) {
  std::uniform_real_distribution<float> value(-1, 1);
  return image_of(width, height, channels, [&](int, int, int) { return value(random); });
}

inline float texel(const StampImage& image, int x, int y, int channel) {
  return image.texels[static_cast<std::size_t>((y * image.width + x) * image.channels + channel)];
}

/// An image with so many texels more on every side, as its wrap says.
inline StampImage extended(const StampImage& image, int by) {
  return image_of(
      image.width + 2 * by, image.height + 2 * by, image.channels, [&](int x, int y, int channel) {
        const std::ptrdiff_t column = wrapped_index(x - by, image.width, image.wrap_u);
        const std::ptrdiff_t row = wrapped_index(y - by, image.height, image.wrap_v);
        return column < 0 || row < 0 ? 0
                                     : texel(image, static_cast<int>(column), static_cast<int>(row), channel);
      });
}

}  // namespace burin::test
