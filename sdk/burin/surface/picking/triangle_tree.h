#pragma once
#include <burin/base/vector.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// A bounding volume hierarchy over the triangles of a surface. Triangles are sorted along a space-filling
/// curve, so consecutive ones have small boxes: a leaf is a run of 8 triangles, and every other node is a run
/// of 8 nodes. The shape of the tree depends on the number of triangles alone, so that it can be updated
/// exactly for moved vertices, in O(k log n) for k triangles. Compared with Embree 3.13 over chunks of the
/// surface, this tree takes 3.5 bytes per triangle instead of 58, is built four times as fast, and an update
/// does not rebuild a tree over all chunks. Embree's user geometry with these leaves takes similar memory,
/// but its boxes are not watertight.
class TriangleTree {
 public:
  using Box = Eigen::AlignedBox3f;

  /// Builds the tree in O(n). The surface must stay in place while the tree exists.
  explicit TriangleTree(const Surface& surface);

  /// Updates the boxes of the triangles of these vertices.
  void update(std::span<const Index> moved_vertices);

  /// The bounding box of all triangles.
  const Box& box() const { return levels_.back().front(); }

  /// Calls query.meet(begin, end) for the runs of triangles in boxes with query.reaches(query.nearest(box)),
  /// nearer boxes first.
  template <class Query>
  void search(Query& query) const;

 private:
  static constexpr std::size_t fan = 8;

  struct Node {
    double nearest;
    std::size_t level, index;
  };
  /// A stack deep enough for 2^32 triangles.
  using Stack = std::array<Node, 10 * fan>;

  void fit(std::size_t level, std::size_t index);
  template <class Query>
  std::size_t push_children(const Node& parent, const Query& query, Stack& stack, std::size_t size) const;

  const Surface& surface_;
  std::vector<std::vector<Box>> levels_;  ///< leaves first, the last level one box
  std::vector<Index> touched_;            ///< nodes of one level to be updated
  std::vector<std::uint8_t> is_touched_;  ///< [leaf] all 0 between updates
};

template <class Query>
void TriangleTree::search(Query& query) const {
  Stack stack;
  std::size_t size = 1;
  stack[0] = {query.nearest(box()), levels_.size() - 1, 0};
  while (size > 0) {
    const Node node = stack[--size];
    if (!query.reaches(node.nearest)) continue;
    if (node.level == 0) {
      const std::size_t begin = node.index * fan;
      query.meet(static_cast<Index>(begin),
                 static_cast<Index>(std::min(begin + fan, surface_.triangles.size())));
    } else {
      size = push_children(node, query, stack, size);
    }
  }
}

/// Pushes the children that the query reaches; the nearest is on top.
template <class Query>
std::size_t TriangleTree::push_children(const Node& parent, const Query& query, Stack& stack,
                                        std::size_t size) const {
  const std::vector<Box>& boxes = levels_[parent.level - 1];
  const std::size_t first = parent.index * fan, bottom = size;
  for (std::size_t index = first; index < std::min(first + fan, boxes.size()); ++index) {
    const double nearest = query.nearest(boxes[index]);
    if (!query.reaches(nearest)) continue;
    std::size_t at = size++;
    for (; at > bottom && stack[at - 1].nearest < nearest; --at) stack[at] = stack[at - 1];
    stack[at] = {nearest, parent.level - 1, index};
  }
  return size;
}

}  // namespace burin
