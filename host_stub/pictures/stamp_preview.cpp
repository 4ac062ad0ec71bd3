// Draws a stamp tiled 3 x 3: samples its mip pyramid over the area of each pixel, and maps values to bytes
// linearly.
#include "pictures/stamp_preview.h"

#include <burin/stamp/area_filter.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr int most_pixels = 512;

/// Maps values linearly to bytes.
struct ToneMap {
  float least, scale;
  std::uint8_t operator()(float value) const {
    return static_cast<std::uint8_t>(std::lround(std::clamp((value - least) * scale, 0.0f, 255.0f)));
  }
};

ToneMap tone_map(const StampImage& image, int shown) {
  auto [least, greatest] = channel_range(image, 0);
  for (int c = 1; c < shown; ++c) {
    const auto [low, high] = channel_range(image, c);
    least = std::min(least, low);
    greatest = std::max(greatest, high);
  }
  // With black wrap there are zeros outside the stamp.
  if (image.wrap_u == Wrap::black || image.wrap_v == Wrap::black) {
    least = std::min(least, 0.0f);
    greatest = std::max(greatest, 0.0f);
  }
  return {least, greatest > least ? 255 / (greatest - least) : 0};
}

}  // namespace

Picture stamp_preview(const MipPyramid& stamp) {
  const StampImage& image = stamp.stamp();
  const double shrink = std::max(
      {1.0, static_cast<double>(image.width) / most_pixels, static_cast<double>(image.height) / most_pixels});
  const int width = std::max(1, static_cast<int>(image.width / shrink));
  const int height = std::max(1, static_cast<int>(image.height / shrink));
  const int shown = image.channels == 1 ? 1 : 3;
  const ToneMap tone = tone_map(image, shown);
  const float pixel_u = 1 / static_cast<float>(width), pixel_v = 1 / static_cast<float>(height);
  Picture picture{3 * width, 3 * height, {}};
  picture.rgb.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 3);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) * pixel_u - 1;
      const float v = (static_cast<float>(y) + 0.5f) * pixel_v - 1;
      for (int c = 0; c < shown; ++c)
        picture.rgb.insert(picture.rgb.end(), shown == 1 ? 3 : 1,
                           tone(sample_area(stamp, c, u, v, {pixel_u, 0, 0, pixel_v})));
    }
  return picture;
}

}  // namespace burin
