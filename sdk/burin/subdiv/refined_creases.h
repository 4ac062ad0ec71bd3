#pragma once
#include <burin/subdiv/refine.h>

#include <array>
#include <vector>

namespace burin {

/// The edges that the creases of a cage have become on the mesh of refine() at this level, as pairs of its
/// vertices, the lower first, ascending. Wherever the surface is rounded there, they are the cage's own
/// lines. Throws the errors of refine(). Computes the topology of all levels: time and memory are O(triangles
/// of the level), nothing if there are no creases.
std::vector<std::array<Index, 2>> refined_creases(const PolygonMesh& cage, SubdivisionScheme scheme,
                                                  int level);

}  // namespace burin
