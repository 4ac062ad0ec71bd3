#pragma once
#include <algorithm>

namespace burin::plugin {

/// 0 for x <= 0, 1 for x >= 1, and between them a cubic with level ends.
inline float smooth_step(float x) {
  const float s = std::clamp(x, 0.0f, 1.0f);
  return s * s * (3 - 2 * s);
}

}  // namespace burin::plugin
