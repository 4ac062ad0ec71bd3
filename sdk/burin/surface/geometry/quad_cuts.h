#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// Decides for each face whether a quad is cut from corner 1 to corner 3 instead of from 0 to 2. The diagonal
/// from 1 is taken if it is the only one inside the quad, or shorter by more than rounding. If the chosen
/// diagonal would connect two vertices that an edge or another quad's diagonal connects already, as in quads
/// that share two edges, the other one is taken if it is free, so that a manifold stays a manifold.
std::vector<bool> cut_from_1_to_3(const PolygonMesh& mesh);

}  // namespace burin
