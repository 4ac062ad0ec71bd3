#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// What is painted on the vertices of a mesh, in their order; each array may be empty.
struct VertexPaint {
  std::vector<std::array<std::uint8_t, 4>> colours;  ///< sRGB and coverage
  std::vector<float> masks;                          ///< 0 = protected .. 1 = free

  bool empty() const { return colours.empty() && masks.empty(); }
};

}  // namespace burin
