#pragma once
#include <burin/surface/polygon_mesh.h>

namespace burin {

/// Throws Error if the cage cannot be refined: a face has a vertex twice, an edge has more than two faces or
/// two with opposite orientation, several separate fans of faces share a vertex, or a crease is not an edge.
/// The message counts faces and vertices from 1.
void check_cage(const PolygonMesh& cage);

}  // namespace burin
