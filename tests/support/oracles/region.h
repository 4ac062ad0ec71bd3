#pragma once
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <span>
#include <vector>

namespace burin::test {

/// Some triangles of a surface as a mesh of their own.
struct Region {
  std::vector<Index> vertices;    ///< [local vertex] of the surface, ascending
  std::vector<Index> triangles;   ///< [local triangle] of the surface, ascending
  std::vector<Triangle> corners;  ///< [local triangle] local vertices
};

/// The region of these triangles, in any order, repeated or not.
Region make_region(const Surface& surface, std::vector<Index> triangles);

/// The triangles at vertices that are not farther than `reach` from one of the points, object units, and
/// connected with the points through such.
Region region_around(const Surface& surface, std::span<const SurfacePoint> points, double reach);

/// The local number of a vertex or triangle in region.vertices or region.triangles, or no_index.
Index local_index(const std::vector<Index>& ascending, Index of_surface);

}  // namespace burin::test
