#pragma once
#include <burin/host/c/burin.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <vector>

namespace burin::c {

/// Reads a mesh from the arrays of a caller, whose struct is complete. Throws plugin::Error, which names the
/// vertex or face, from 0, for what burin_mesh does not allow; also for corners that name no vertex and
/// coordinates that are not finite as floats.
TriangleMesh read_arrays(const burin_mesh& given);

/// The same with the faces as they are.
PolygonMesh read_polygons(const burin_mesh& given);

/// [triangle of read_arrays()] the number of the face that it is of.
std::vector<Index> read_triangle_faces(const burin_mesh& given);

/// The size of burin_mesh before 0.3, which all callers have at least.
inline bool has_first(const burin_mesh* mesh) { return mesh && BURIN_HAS(mesh, burin_mesh, refines); }

}  // namespace burin::c
