#pragma once
#include <burin/surface/surface.h>

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

/// The local number of a vertex or triangle in region.vertices or region.triangles, or no_index.
Index local_index(const std::vector<Index>& ascending, Index of_surface);

}  // namespace burin::test
