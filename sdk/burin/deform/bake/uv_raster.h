#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// Which triangle covers each texel of a square image of the unit square of texture coordinates: u to the
/// right, v up, so that row 0, the top, lies below v = 1.
struct UvRaster {
  int size = 0;  ///< texels a side
  std::vector<Index>
      triangle;              ///< [row * size + column], the lowest that holds the texel's centre; or no_index
  std::size_t overlaps = 0;  ///< texels whose centre lies inside several triangles

  /// Of a texel, in texture coordinates.
  Vec2d centre(std::size_t texel) const;
};

/// Parts of triangles outside the unit square are left out, triangles without an area there too.
UvRaster rasterise(std::span<const TriangleUv> triangles, int size);

/// Barycentric coordinates of a point with respect to a triangle; not finite when that has no area.
Vec3d barycentric(const TriangleUv& triangle, const Vec2d& point);

}  // namespace burin
