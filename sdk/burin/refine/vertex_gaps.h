#pragma once
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin {

/// How far apart the vertices of a surface are that nothing was drawn on yet, whatever strokes do to it. The
/// gap at an edge is twice the distance from its middle to the nearest corner of its triangles: the length of
/// the edge, or less where a corner lies near the middle of the long side of a sliver. So single slivers in a
/// fine mesh leave no gap, and rows of them, as CAD makes, do.
class VertexGaps {
 public:
  /// Those of a surface as it is. Costs O(edges), on all threads.
  explicit VertexGaps(const Surface& surface);

  /// The greatest gap at the edges of a vertex, object units.
  float operator[](Index vertex) const { return gaps_[vertex]; }
  float greatest() const { return greatest_; }  ///< of all

  /// What becomes of new vertices.
  enum class Fresh {
    measured,  ///< they have the gaps that they leave
    refined    ///< their gaps are infinite: where a stroke refined a surface, others may have to
  };

  /// Those of a surface that was patched. `came_from`: [vertex] its number before, or more.
  VertexGaps patched(const Surface& after, std::span<const Index> came_from, Fresh fresh) const;

 private:
  VertexGaps() = default;
  void find_greatest();

  std::vector<float> gaps_;  ///< [vertex]
  float greatest_ = 0;
};

}  // namespace burin
