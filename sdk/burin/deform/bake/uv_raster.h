#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// The triangle that covers each texel of a square image of the unit square of texture coordinates. u runs to
/// the right and v up, so that row 0, the top row, lies below v = 1.
struct UvRaster {
  int size = 0;  ///< texels per side
  std::vector<Index>
      triangle;              ///< [row * size + column], the lowest that holds the texel's centre; or no_index
  std::size_t overlaps = 0;  ///< texels whose centre lies inside several triangles

  /// The centre of a texel in texture coordinates.
  Vec2d centre(std::size_t texel) const;
};

/// Rasterises triangles. Parts outside the unit square and triangles without an area in texture space are
/// left out.
UvRaster rasterise(std::span<const TriangleUv> triangles, int size);

/// Barycentric coordinates of a point with respect to a triangle; not finite when that has no area.
Vec3d barycentric(const TriangleUv& triangle, const Vec2d& point);

}  // namespace burin
