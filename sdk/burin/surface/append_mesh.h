#pragma once
#include <burin/surface/triangle_mesh.h>

namespace burin {

/// Adds a mesh to another, behind its vertices and triangles. Where only one has texture coordinates the
/// other gets 0.
void append(const TriangleMesh& part, TriangleMesh& into);

}  // namespace burin
