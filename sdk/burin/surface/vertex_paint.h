#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// A colour: red, green and blue in sRGB, and coverage, from 0 (clay only) to 255 (the colour hides the
/// clay).
using PaintBytes = std::array<std::uint8_t, 4>;

/// Colours and masks of the vertices of a mesh; each array may be empty.
struct VertexPaint {
  std::vector<PaintBytes> colours;  ///< [vertex]
  std::vector<float> masks;         ///< [vertex] 0 = protected .. 1 = free

  bool empty() const { return colours.empty() && masks.empty(); }  ///< whether nothing is painted
};

}  // namespace burin
