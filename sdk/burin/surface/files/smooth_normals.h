#pragma once
#include <burin/surface/triangle_mesh.h>

#include <vector>

namespace burin {

/// A unit normal for each vertex, outward: the NormalSum of all triangles at its place, so that it is the
/// same on both sides of a seam where vertices are split.
std::vector<Vec3f> smooth_normals(const TriangleMesh& mesh);

}  // namespace burin
