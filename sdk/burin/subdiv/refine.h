#pragma once
#include <burin/base/progress.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <cstddef>

// The functions may be called on any thread, also on several at once. Inside they use all threads of oneTBB.
namespace burin {

/// The rules of subdivision.
enum class SubdivisionScheme {
  catmull_clark,  ///< Catmull and Clark 1978
  loop,           ///< Loop 1987; triangles only
};

/// Loop for a cage of triangles only, else Catmull-Clark.
SubdivisionScheme natural_scheme(const PolygonMesh& cage);

/// The number of triangles of refine() at this level, if the cage has no holes.
std::size_t refined_triangle_count(const PolygonMesh& cage, SubdivisionScheme scheme, int level);

/// The lowest level with at least `triangles` triangles. Throws Error if that would have more than 2^30
/// triangles.
int level_for_triangles(const PolygonMesh& cage, SubdivisionScheme scheme, std::size_t triangles);

/// Refines a cage by `level` uniform steps. Positions are those of that level, not of the limit surface.
/// Creases, corners, holes and boundary rules are respected. Quads are split into triangles, with the same
/// direction of all diagonals inside a quad of the cage. Texture coordinates, if the cage has them, are
/// smooth inside an island and linear along its border (OpenSubdiv's FVAR_LINEAR_BOUNDARIES). Level 0 gives
/// the triangulated cage, whatever its topology. Higher levels throw Error that names the face, edge or
/// vertex, counted from 1, if the cage is not a manifold with consistent orientation, a face has a vertex
/// twice or a crease is not an edge; also for more than 2^30 triangles, and for Loop on a cage with larger
/// polygons. Time and memory are O(triangles of the level).
TriangleMesh refine(const PolygonMesh& cage, SubdivisionScheme scheme, int level,
                    const Progress& progress = {});

}  // namespace burin
