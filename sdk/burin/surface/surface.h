#pragma once
#include <burin/base/progress.h>
#include <burin/surface/csr.h>
#include <burin/surface/triangle_mesh.h>

#include <vector>

// make_surface() may be called on any thread, also on several at once. Inside it uses all threads of oneTBB.
namespace burin {

/// A triangle mesh prepared for strokes: vertices and triangles sorted along a space-filling curve, with unit
/// vertex normals, curvature and neighbourhoods. Any triangle soup is accepted: non-manifold, open,
/// degenerate. A point set (make_point_surface()) is a surface without triangles.
struct Surface {
  std::vector<Vec3f> positions;         ///< object units
  std::vector<Vec3f> normals;           ///< [vertex] outward, unit and finite; see normals.h
  std::vector<Triangle> triangles;      ///< no triangle has a vertex twice
  std::vector<float> gauss_curvature;   ///< [vertex] see curvature.h
  std::vector<TriangleUv> triangle_uv;  ///< [triangle], or empty; those of the original mesh
  Csr neighbours;                       ///< [vertex] vertices joined by an edge or link, ascending
  Csr incident;                         ///< [vertex] triangles around it, ascending
  std::vector<Index> source_vertex;     ///< [vertex] its index in the original mesh or point set
  double scale = 0;                     ///< diagonal of the original bounding box, object units

  Index vertex_count() const { return static_cast<Index>(positions.size()); }  ///< also of points
  bool is_point_set() const { return triangles.empty(); }                      ///< see make_point_surface()
};

/// Triangles that take the place of others of a surface.
struct SurfacePatch {
  std::vector<Index> removed;           ///< triangles of the surface, ascending
  std::vector<Vec3f> positions;         ///< [new vertex] object units
  std::vector<Triangle> triangles;      ///< vertices of the surface, and from its vertex_count() on new ones
  std::vector<TriangleUv> triangle_uv;  ///< [new triangle], or empty
};

/// Makes a surface of a triangle mesh. Triangles that have a vertex twice are left out; unreferenced vertices
/// stay. `progress` may be empty. The result depends on the mesh alone. Throws Error if no triangle has an
/// area or a position is not finite, ContractError if a triangle refers to a vertex that does not exist.
Surface make_surface(TriangleMesh mesh, const Progress& progress = {});

}  // namespace burin
