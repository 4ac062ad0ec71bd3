// Converts paint between sRGB bytes in the vertex order of the mesh and linear floats in that of the surface,
// and computes the colours of painted clay for pictures.
#include "pictures/painted.h"

#include <burin/deform/paint_bytes.h>

#include <algorithm>

namespace burin {
namespace {

/// The brightness of fully protected points.
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

Paint paint_in_surface_order(const Surface& surface, const VertexPaint& paint) {
  Paint of_surface;
  for (const Index source : surface.source_vertex) {
    if (!paint.colours.empty()) of_surface.colour.push_back(colour_of(paint.colours[source]));
    if (!paint.masks.empty()) of_surface.mask.push_back(paint.masks[source]);
  }
  return of_surface;
}

VertexPaint paint_in_source_order(const Surface& surface, const Paint& paint) {
  VertexPaint of_source;
  const auto is_bare = [](const Vec4f& colour) { return colour.w() == 0; };
  if (!std::ranges::all_of(paint.colour, is_bare)) {
    of_source.colours.resize(paint.colour.size());
    for (std::size_t vertex = 0; vertex < paint.colour.size(); ++vertex)
      of_source.colours[surface.source_vertex[vertex]] = bytes_of(paint.colour[vertex]);
  }
  const auto is_free = [](float mask) { return mask == 1; };
  if (!std::ranges::all_of(paint.mask, is_free)) {
    of_source.masks.resize(paint.mask.size());
    for (std::size_t vertex = 0; vertex < paint.mask.size(); ++vertex)
      of_source.masks[surface.source_vertex[vertex]] = paint.mask[vertex];
  }
  return of_source;
}

}  // namespace burin
