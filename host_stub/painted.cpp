#include "painted.h"

#include <cmath>

#include "srgb.h"

namespace burin {
namespace {

/// Of clay, where nothing may be moved.
constexpr float protected_brightness = 0.35f;

Tint tint_at(const Paint& paint, const SurfacePoint& point) {
  Tint tint = Tint::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Index vertex = point.corners[i];
    tint += point.weights[i] * tint_of(paint.colour_of(vertex), paint.mask_of(vertex));
  }
  return tint;
}

}  // namespace

Albedo painted(const Paint& paint) {
  if (paint.colour.empty() && paint.mask.empty()) return clay;
  return [&paint](const SurfacePoint& point) -> Vec3f {
    const Tint tint = tint_at(paint, point);
    const Vec3f colour = tint.head<3>() + (1 - tint[3]) * clay(point);
    return colour * (protected_brightness + (1 - protected_brightness) * tint[4]);
  };
}

VertexPaint paint_in_source_order(const Surface& surface, const Paint& paint) {
  VertexPaint of_source;
  of_source.colours.resize(paint.colour.size());
  of_source.masks.resize(paint.mask.size());
  for (std::size_t vertex = 0; vertex < paint.colour.size(); ++vertex) {
    const Vec4f& colour = paint.colour[vertex];
    auto& bytes = of_source.colours[surface.source_vertex[vertex]];
    for (int k = 0; k < 3; ++k) bytes[static_cast<std::size_t>(k)] = to_srgb(colour[k]);
    bytes[3] = static_cast<std::uint8_t>(std::lround(255 * colour.w()));
  }
  for (std::size_t vertex = 0; vertex < paint.mask.size(); ++vertex)
    of_source.masks[surface.source_vertex[vertex]] = paint.mask[vertex];
  return of_source;
}

}  // namespace burin
