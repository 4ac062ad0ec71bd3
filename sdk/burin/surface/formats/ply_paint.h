#pragma once
#include <burin/surface/formats/ply_header.h>
#include <burin/surface/vertex_paint.h>

#include <string>

namespace burin {

/// What the vertices of a PLY file have painted on them: properties red, green and blue, with or without
/// alpha, ink_red, ink_green, ink_blue and ink_alpha, and mask. Channels are sRGB from 0 to 1 where they are
/// floating-point, to 65535 where they are ushort, else to 255; what lies beyond by no more than rounding is
/// clamped. Other properties are passed over, and so are colours that lack a channel.
class PlyPaint {
 public:
  /// `vertices` must outlive this.
  explicit PlyPaint(const PlyElement& vertices);

  /// Whether a property, by its number, is painted.
  bool takes(std::size_t property) const { return slots_[property] != Slot::none; }

  /// Takes a value of a vertex. Returns what is wrong with it, or nothing.
  std::string take(std::size_t property, std::uint64_t vertex, double value);

  /// To be called once, when all values are taken.
  VertexPaint finish();

 private:
  enum class Slot { none = -1, red, green, blue, alpha, ink_red, ink_green, ink_blue, ink_alpha, mask };

  VertexPaint paint_;
  std::vector<PaintBytes> ink_;

  const PlyElement& vertices_;
  std::vector<Slot> slots_;  ///< [property]
};

}  // namespace burin
