#pragma once
#include <burin/base/srgb.h>
#include <burin/base/vector.h>
#include <burin/surface/vertex_paint.h>

#include <cmath>

namespace burin {

/// Linear red, green, blue and coverage, 0..1, of a colour of a file.
inline Vec4f colour_of(const PaintBytes& bytes) {
  return {from_srgb(bytes[0]), from_srgb(bytes[1]), from_srgb(bytes[2]), static_cast<float>(bytes[3]) / 255};
}

/// The colour of a file that is nearest to linear red, green, blue and coverage, 0..1.
inline PaintBytes bytes_of(const Vec4f& colour) {
  return {to_srgb(colour.x()), to_srgb(colour.y()), to_srgb(colour.z()),
          static_cast<std::uint8_t>(std::lround(255 * colour.w()))};
}

}  // namespace burin
