#pragma once
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin {

/// Encodes linear light as an sRGB byte [IEC 61966-2-1]; clamps it to 0..1.
inline std::uint8_t to_srgb(float light) {
  const float x = std::clamp(light, 0.0f, 1.0f);
  const float encoded =
      x <= 0.0031308f ? 12.92f * x
                      : 1.055f * static_cast<float>(math::pow(static_cast<double>(x), 1 / 2.4)) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

/// Decodes an sRGB byte to linear light, 0..1.
inline float from_srgb(std::uint8_t byte) {
  const float x = static_cast<float>(byte) / 255;
  return x <= 0.04045f ? x / 12.92f
                       : static_cast<float>(math::pow(static_cast<double>((x + 0.055f) / 1.055f), 2.4));
}

}  // namespace burin
