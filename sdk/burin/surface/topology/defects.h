#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cstddef>
#include <string>

namespace burin {

/// The numbers of defects of a triangle mesh.
struct MeshDefects {
  std::size_t non_manifold_edges = 0;     ///< edges of more than two triangles
  std::size_t non_manifold_vertices = 0;  ///< vertices whose triangles form more than one fan
  std::size_t flipped_edges = 0;          ///< edges whose two triangles disagree on the outside
  std::size_t degenerate_triangles = 0;   ///< a repeated vertex or no area
  std::size_t duplicate_triangles = 0;    ///< the same three vertices as an earlier triangle
  std::size_t duplicate_positions = 0;    ///< vertices at the position of an earlier vertex
  std::size_t unreferenced_vertices = 0;  ///< vertices of no triangle

  bool any() const;
  /// Lists the counts that are not zero: "12 non-manifold edges, 3 degenerate triangles".
  std::string text() const;
};

/// Counts the defects of a mesh, in O(n log n).
MeshDefects find_defects(const TriangleMesh& mesh);

}  // namespace burin
