#pragma once
#include <burin/stamp/stamp_image.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace burin {

/// Two neighbouring texels and the weight of the second.
struct TexelSpan {
  std::ptrdiff_t first, second;
  float weight;
};

/// The part of a finite coordinate in its period, 0..1. Without a call of std::floor, which costs more than
/// all the rest of a sample where the machine has no instruction for it.
inline double in_period(float coordinate) {
  constexpr float first_whole = 8388608;  // from here on all floats are whole numbers
  if (!(std::abs(coordinate) < first_whole)) return 0;
  const double whole = static_cast<std::int32_t>(coordinate);
  return coordinate - (coordinate < whole ? whole - 1 : whole);
}

/// In double, so that only the float coordinate itself limits the precision.
inline TexelSpan texel_span(double in_period, int size) {
  const double place = in_period * size - 0.5;  // in [-0.5, size - 0.5]
  const int below = place < 0 ? -1 : static_cast<int>(place);
  return {below < 0 ? size - 1 : below, below + 1 == size ? 0 : below + 1, static_cast<float>(place - below)};
}

/// At a place that in_period gave.
inline float bilinear(const StampImage& image, int channel, double u, double v) {
  const TexelSpan x = texel_span(u, image.width), y = texel_span(v, image.height);
  const float* texels = image.texels.data() + channel;
  const auto at = [&](std::ptrdiff_t column, std::ptrdiff_t row) {
    return texels[(row * image.width + column) * image.channels];
  };
  const auto mix = [](float a, float b, float weight) { return a * (1 - weight) + b * weight; };
  return mix(mix(at(x.first, y.first), at(x.second, y.first), x.weight),
             mix(at(x.first, y.second), at(x.second, y.second), x.weight), y.weight);
}

}  // namespace burin
