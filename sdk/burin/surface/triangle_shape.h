#pragma once
#include <burin/surface/triangle_mesh.h>

namespace burin {

bool names_a_vertex_twice(const Triangle& triangle);

/// False when the corners lie on one line, exactly.
bool has_area(const TriangleMesh& mesh, const Triangle& triangle);

}  // namespace burin
