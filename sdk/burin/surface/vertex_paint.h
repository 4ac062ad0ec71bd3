#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// A colour: red, green and blue in sRGB, and coverage, how much of the clay below it hides.
using PaintBytes = std::array<std::uint8_t, 4>;

/// What is painted on the vertices of a mesh, in their order; each array may be empty.
struct VertexPaint {
  std::vector<PaintBytes> colours;
  std::vector<float> masks;  ///< 0 = protected .. 1 = free

  bool empty() const { return colours.empty() && masks.empty(); }
};

}  // namespace burin
