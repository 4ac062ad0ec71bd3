#pragma once
#include <burin/surface/formats/ply_header.h>
#include <burin/surface/vertex_paint.h>

#include <string>

namespace burin {

/// Colours and masks of the vertices of a PLY file. The properties are red, green and blue, or r, g and b,
/// optionally alpha; ink_red, ink_green, ink_blue and ink_alpha; and mask. Channels are sRGB; floating-point
/// ones range from 0 to 1, ushort ones to 65535, all others to 255. Values outside the range by no more than
/// rounding are clamped. Other properties, and colours that lack a channel, are ignored.
class PlyPaint {
 public:
  /// `vertices` must outlive the object.
  explicit PlyPaint(const PlyElement& vertices);

  /// Whether a property, given by its index, is a colour channel or mask.
  bool takes(std::size_t property) const { return slots_[property] != Slot::none; }

  /// Stores a value of a vertex; values of other properties are ignored. Returns an error message, or an
  /// empty string.
  std::string take(std::size_t property, std::uint64_t vertex, double value);

  /// Returns the result. May be called once, after all values.
  VertexPaint finish();

 private:
  enum class Slot { none = -1, red, green, blue, alpha, ink_red, ink_green, ink_blue, ink_alpha, mask };

  VertexPaint paint_;
  std::vector<PaintBytes> ink_;

  const PlyElement& vertices_;
  std::vector<Slot> slots_;  ///< [property]
};

}  // namespace burin
