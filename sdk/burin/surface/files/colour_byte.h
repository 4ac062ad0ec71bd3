#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin {

/// By so much files go beyond the range of a colour's channels, 0 to 1, when they were rounded.
inline constexpr double colour_rounding = 1e-3;

/// A channel from 0 to 1 as a byte; what lies beyond is clamped.
inline std::uint8_t colour_byte(double channel) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
}

}  // namespace burin
