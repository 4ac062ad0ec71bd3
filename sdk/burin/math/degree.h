#pragma once
#include <numbers>

namespace burin::math {

inline constexpr double degree = std::numbers::pi / 180;  ///< in radians

}  // namespace burin::math
