#pragma once
#include <burin/base/progress.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <cstddef>

namespace burin {

enum class SubdivisionScheme {
  catmull_clark,
  loop,  ///< triangles only
};

/// Loop for a cage of triangles only, else Catmull-Clark.
SubdivisionScheme natural_scheme(const PolygonMesh& cage);

/// Triangles that refine() gives at this level, but for holes.
std::size_t refined_triangle_count(const PolygonMesh& cage, SubdivisionScheme scheme, int level);

/// The lowest level with at least `triangles` triangles. Throws Error beyond 2^30 triangles.
int level_for_triangles(const PolygonMesh& cage, SubdivisionScheme scheme, std::size_t triangles);

/// Vertices of the refined cage after `level` uniform steps (positions of that level, not of the limit
/// surface), creases, corners, holes and rules honoured; quads split into triangles, all diagonals inside a
/// quad of the cage the same way. Texture coordinates are refined where the cage has them: smooth inside an
/// island, linear along its border (OpenSubdiv's FVAR_LINEAR_BOUNDARIES). Level 0 gives the triangulated
/// cage, whatever its topology. Above it, throws Error naming the face, edge or vertex, counted from 1, when
/// the cage is not a manifold with consistent orientation, has a face that names a vertex twice or a crease
/// that is no edge; for a level of more than 2^30 triangles; for Loop on a cage with larger polygons.
TriangleMesh refine(const PolygonMesh& cage, SubdivisionScheme scheme, int level,
                    const Progress& progress = {});

}  // namespace burin
