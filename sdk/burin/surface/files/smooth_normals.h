#pragma once
#include <burin/surface/triangle_mesh.h>

#include <vector>

namespace burin {

/// The outward unit normal of each vertex: the NormalSum of all triangles at its position, so that the
/// normals on both sides of a seam of split vertices are equal.
std::vector<Vec3f> smooth_normals(const TriangleMesh& mesh);

}  // namespace burin
