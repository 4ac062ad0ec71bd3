#pragma once
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <span>
#include <vector>

namespace burin::test {

/// Some triangles of a surface as a separate mesh.
struct Region {
  std::vector<Index> vertices;    ///< [local vertex] vertex of the surface, ascending
  std::vector<Index> triangles;   ///< [local triangle] triangle of the surface, ascending
  std::vector<Triangle> corners;  ///< [local triangle] local vertices
};

/// The region of these triangles, which may be in any order and may be repeated.
Region make_region(const Surface& surface, std::vector<Index> triangles);

/// The triangles at vertices that are at most `reach`, object units, from one of the points, and that are
/// connected with the points through such vertices.
Region region_around(const Surface& surface, std::span<const SurfacePoint> points, double reach);

/// The local index of a vertex or triangle in region.vertices or region.triangles, or no_index.
Index local_index(const std::vector<Index>& ascending, Index of_surface);

}  // namespace burin::test
