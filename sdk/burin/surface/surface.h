#pragma once
#include <burin/base/progress.h>
#include <burin/surface/csr.h>
#include <burin/surface/triangle_mesh.h>

#include <vector>

namespace burin {

/// A triangle mesh made ready for strokes: vertices and triangles sorted along a space-filling curve,
/// unit vertex normals, neighbourhoods. Any triangle soup will do: non-manifold, open, degenerate. Or a point
/// set (make_point_surface), which has no triangles.
struct Surface {
  std::vector<Vec3f> positions;        ///< object units
  std::vector<Vec3f> normals;          ///< unit and finite at every vertex, outward, see normals.h
  std::vector<Triangle> triangles;     ///< no triangle names a vertex twice
  std::vector<float> gauss_curvature;  ///< [vertex] see curvature.h
  Csr neighbours;                      ///< vertices joined by an edge or link, ascending, each once
  Csr incident;                        ///< triangles around a vertex, ascending
  std::vector<Index> source_vertex;    ///< [vertex] its index in the mesh or point set it was made of
  double scale = 0;                    ///< diagonal of the bounding box when the surface was made

  Index vertex_count() const { return static_cast<Index>(positions.size()); }
  bool is_point_set() const { return triangles.empty(); }
};

/// Sorts and connects. Triangles that name a vertex twice are left out; unreferenced vertices stay.
/// Throws Error when no triangle with an area remains or a position is not finite, ContractError when a
/// triangle names a vertex that is not there. The result depends on the mesh alone.
Surface make_surface(TriangleMesh mesh, const Progress& progress = {});

}  // namespace burin
