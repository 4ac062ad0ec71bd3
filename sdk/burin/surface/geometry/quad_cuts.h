#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// Which quads are to be cut from corner 1 to corner 3 instead of 0 to 2 [face]: where that is the only
/// diagonal inside, or the shorter by more than rounding. But where a diagonal would run between two vertices
/// that an edge or another quad's diagonal joins already, as in quads that share two edges, the other one is
/// taken, so that a manifold stays one; as long as there is one that is free.
std::vector<bool> cut_from_1_to_3(const PolygonMesh& mesh);

}  // namespace burin
