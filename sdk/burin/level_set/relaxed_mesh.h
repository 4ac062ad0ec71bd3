#pragma once
#include <burin/level_set/grid/grid_surface.h>
#include <burin/surface/triangle_mesh.h>

#include <functional>
#include <vector>

namespace burin {

/// Brings positions onto a surface that is near them.
using BringToSurface = std::function<void(std::vector<Vec3f>& positions)>;

/// Moves the vertices of a closed mesh of a smooth surface along it, until they stand about as far from their
/// neighbours on all sides, and leaves its connections as they are. Then moves them outward by what the flat
/// triangles leave out of the surface in the mean, so that the mesh holds the surface's volume.
void relax(TriangleMesh& mesh, const BringToSurface& bring);

/// The surface of a grid: brought to where the distance is 0, and relaxed, but where triangles would go
/// through each other or turn over.
TriangleMesh relaxed_mesh(const GridSurface& surface);

}  // namespace burin
