#pragma once
#include <burin/host/c/burin.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

namespace burin::c {

/// Reads a mesh from the arrays of a caller, whose struct is complete. Throws plugin::Error, which names the
/// vertex or face, from 0, for what burin_mesh does not allow; also for corners that name no vertex and
/// coordinates that are not finite as floats.
TriangleMesh read_arrays(const burin_mesh& given);

/// The same with the faces as they are.
PolygonMesh read_polygons(const burin_mesh& given);

}  // namespace burin::c
