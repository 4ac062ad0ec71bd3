#pragma once
#include <burin/surface/formats/ply_header.h>
#include <burin/surface/vertex_paint.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Colours and masks of the vertices of a PLY file. The properties are red, green and blue, or r, g and b,
/// optionally alpha; ink_red, ink_green, ink_blue and ink_alpha; and mask. Channels are sRGB; floating-point
/// ones range from 0 to 1, or to 255 if all of the file's are whole numbers or any is far above 1; ushort
/// ones to 65535, all others to 255. Values outside the range by no more than rounding are clamped. Other
/// properties, and colours that lack a channel, are ignored.
class PlyPaint {
 public:
  /// `vertices` must outlive the object.
  explicit PlyPaint(const PlyElement& vertices);

  /// Whether a property, given by its index, is a colour channel or mask.
  bool takes(std::size_t property) const { return slots_[property] != Slot::none; }

  /// Stores a value of a vertex; values of other properties are ignored. Returns an error message, or an
  /// empty string.
  std::string take(std::size_t property, std::uint64_t vertex, double value);

  /// The first vertex with a floating-point channel that is in neither range, and the error message. May be
  /// called once, after all values.
  struct Fault {
    std::uint64_t vertex;
    std::string message;
  };
  std::optional<Fault> settle_reals();

  /// Returns the result. May be called once, at last.
  VertexPaint finish();

 private:
  enum class Slot { none = -1, red, green, blue, alpha, ink_red, ink_green, ink_blue, ink_alpha, mask };

  /// Whether a property is a channel of the colours whose range only all vertices together tell.
  bool is_real(std::size_t property) const;

  VertexPaint paint_;
  std::vector<PaintBytes> ink_;
  /// [vertex] its channels where these are floating-point, else 0; empty if none is.
  std::vector<std::array<float, 4>> reals_;

  const PlyElement& vertices_;
  std::vector<Slot> slots_;  ///< [property]
};

}  // namespace burin
