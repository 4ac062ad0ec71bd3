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

/// Boxes around the triangles of a surface. Triangles lie along a space-filling curve, so those that follow
/// each other make small boxes: the leaves are runs of 8 triangles, and every node above them is a run of 8
/// nodes. The tree's shape depends on the number of triangles alone, so that it can follow moved vertices
/// exactly, at a cost that knows nothing of the rest of the surface.
/// Measured against Embree 3.13 in chunks: 3.5 bytes a triangle instead of 58, built four times as fast, and
/// an update does not rebuild a tree over all chunks. With these leaves as Embree's user geometry memory is
/// alike, but its boxes around such are not watertight.
class TriangleTree {
 public:
  using Box = Eigen::AlignedBox3f;

  /// Over a surface that stays in place while the tree lives.
  explicit TriangleTree(const Surface& surface);

  /// Fits the boxes of these vertices' triangles again.
  void update(std::span<const Index> moved_vertices);

  /// Around all triangles.
  const Box& box() const { return levels_.back().front(); }

  /// Calls query.meet(begin, end) for runs of triangles until query.reaches(query.nearest(box)) is false of
  /// the boxes around all others; nearer boxes first.
  template <class Query>
  void search(Query& query) const;

 private:
  static constexpr std::size_t fan = 8;

  struct Node {
    double nearest;
    std::size_t level, index;
  };
  /// Enough for the leaves of 2^32 triangles.
  using Stack = std::array<Node, 10 * fan>;

  void fit(std::size_t level, std::size_t index);
  template <class Query>
  std::size_t push_children(const Node& parent, const Query& query, Stack& stack, std::size_t size) const;

  const Surface& surface_;
  std::vector<std::vector<Box>> levels_;  ///< leaves first, the last level one box
  std::vector<Index> touched_;            ///< nodes of one level to be fitted again
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

/// Leaves the nearest on top.
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
