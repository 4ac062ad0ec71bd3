// Bilinear samples and the range of an image.
#include <burin/stamp/stamp_image.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace burin {
namespace {

/// Two neighbouring texels, no_texel outside a black wrap's borders, and the weight of the second.
struct TexelSpan {
  std::ptrdiff_t first, second;
  float weight;
};

/// The texels around a coordinate. Computes in double, so that only the float coordinate limits the
/// precision.
TexelSpan texel_span(float coordinate, int size, Wrap wrap) {
  const double place = wrapped_coordinate(coordinate, wrap, 1.0 / size) * size - 0.5;
  const int below = place < -1 ? -2 : place < 0 ? -1 : static_cast<int>(place);
  return {wrapped_index(below, size, wrap), wrapped_index(below + 1, size, wrap),
          static_cast<float>(place - below)};
}

}  // namespace

std::pair<float, float> channel_range(const StampImage& image, int channel) {
  constexpr float beyond = std::numeric_limits<float>::infinity();
  std::pair<float, float> range = {beyond, -beyond};
  for (std::size_t i = static_cast<std::size_t>(channel); i < image.texels.size();
       i += static_cast<std::size_t>(image.channels))
    range = {std::min(range.first, image.texels[i]), std::max(range.second, image.texels[i])};
  return range;
}

void set_range(StampImage& image) { std::tie(image.minimum, image.maximum) = channel_range(image, 0); }

float sample_bilinear(const StampImage& image, int channel, float u, float v) {
  if (!std::isfinite(u) || !std::isfinite(v)) return std::numeric_limits<float>::quiet_NaN();
  const TexelSpan x = texel_span(u, image.width, image.wrap_u), y = texel_span(v, image.height, image.wrap_v);
  const float* texels = image.texels.data() + channel;
  const auto at = [&](std::ptrdiff_t column, std::ptrdiff_t row) {
    return column < 0 || row < 0 ? 0.0f : texels[(row * image.width + column) * image.channels];
  };
  const auto mix = [](float a, float b, float weight) { return a * (1 - weight) + b * weight; };
  return mix(mix(at(x.first, y.first), at(x.second, y.first), x.weight),
             mix(at(x.first, y.second), at(x.second, y.second), x.weight), y.weight);
}

}  // namespace burin
