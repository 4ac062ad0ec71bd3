#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin {

/// By this much rounded colour channels in files may lie outside the range 0 to 1.
inline constexpr double colour_rounding = 1e-3;

/// Converts a channel from 0 to 1 to a byte; values outside the range are clamped.
inline std::uint8_t colour_byte(double channel) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
}

}  // namespace burin
