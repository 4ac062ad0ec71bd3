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

/// Triangles that refine() gives at this level.
std::size_t refined_triangle_count(const PolygonMesh& cage, SubdivisionScheme scheme, int level);

/// The lowest level with at least `triangles` triangles. Throws Error beyond 2^31 triangles.
int level_for_triangles(const PolygonMesh& cage, SubdivisionScheme scheme, std::size_t triangles);

/// Vertices of the refined cage after `level` uniform steps (positions of that level, not of the limit
/// surface), creases, corners and boundary rule honoured; quads split into triangles. Level 0 gives the
/// triangulated cage. Throws Error naming the face or edge when the cage is not a manifold with
/// consistent orientation or has a face that names a vertex twice.
TriangleMesh refine(const PolygonMesh& cage, SubdivisionScheme scheme, int level, const Progress& progress = {});

}  // namespace burin
