#pragma once
#include <burin/refine/edge_length.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin {

/// Where the triangles of a surface are too large for a displacement.
struct DisplacementError {
  std::vector<EdgeLength::Around> lengths;  ///< that edges there may have; near the one before it
  std::vector<Index> triangles;             ///< at these edges

  bool empty() const { return lengths.empty(); }
};

/// How a displacement is to be represented.
struct DisplacementBound {
  double share = 0;       ///< of the greatest displacement: the error that there may be between vertices
  double least_edge = 0;  ///< edges of at most longest_edge_factor times this length are left, object units
};

/// Finds the edges beside which a displacement, linear in each triangle, may be off by more than the bound:
/// where the two diagonals of the two triangles at an edge disagree by more than twice that. A second
/// search after refinement finds none where the displacement is smooth; at steps edges get a third as long
/// each time, down to the least. `displaced`: positions, of which those of `vertices` may differ from the
/// surface's. Costs O(vertices).
DisplacementError displacement_error(const Surface& surface, std::span<const Vec3f> displaced,
                                     std::span<const Index> vertices, const DisplacementBound& bound);

}  // namespace burin
