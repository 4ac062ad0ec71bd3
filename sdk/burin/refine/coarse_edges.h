#pragma once
#include <burin/surface/surface.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Looks for edges that are too long around places of a surface, one after the other: what an event of the
/// pen asks. Reused from place to place to keep its memory.
class CoarseEdges {
 public:
  /// Whether an edge longer than `longest` begins or ends within `reach` of a line, or belongs to the
  /// triangle from which the search goes on over the surface. Lengths in object units. Costs O(vertices
  /// within reach).
  bool are_near(const Surface& surface, Index triangle, const Vec3d& from, const Vec3d& to, double reach,
                double longest);

 private:
  void visit(Index vertex);

  std::vector<Index> open_;
  std::vector<std::uint32_t> seen_;  ///< [vertex] the number of the search that saw it
  std::uint32_t search_ = 0;
};

}  // namespace burin
