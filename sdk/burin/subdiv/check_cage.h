#pragma once
#include <burin/surface/polygon_mesh.h>

namespace burin {

/// Throws Error when the cage cannot be refined: a face that names a vertex twice, an edge of more than two
/// faces or of two that disagree on the outside, a vertex where separate fans of faces touch, a crease that
/// is no edge. Faces and vertices are counted from 1 in the message.
void check_cage(const PolygonMesh& cage);

}  // namespace burin
