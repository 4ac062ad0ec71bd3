#pragma once
#include <burin/base/parallel.h>
#include <burin/base/trees/box_lanes.h>
#include <burin/base/vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace burin {

/// A bounding volume hierarchy over items: the triangles of a surface, or discs around points. Items are
/// sorted along a space-filling curve, so consecutive ones have small boxes: a leaf is a run of 8 items, and
/// every other node is a run of 8 nodes. The shape of the tree depends on the number of items alone, so that
/// it can be updated exactly for moved items, in O(k log n) for k items. Compared with Embree 3.13 over
/// chunks of a surface, this tree takes 3.5 bytes per triangle instead of 58, is built four times as fast,
/// and an update does not rebuild a tree over all chunks. Embree's user geometry with these leaves takes
/// similar memory, but its boxes are not watertight. `Items` has size(), and extend(box, item), which
/// enlarges a box to contain the item.
template <class Items>
class BoxTree {
 public:
  using Box = Eigen::AlignedBox3f;

  /// The number of items in a run, and of nodes in a node.
  static constexpr std::size_t fan = BoxLanes::count;

  explicit BoxTree(Items items);

  /// Updates the boxes of these items, given in any order, also several times.
  template <class Changed>
  void update(const Changed& changed);

  const Items& items() const { return items_; }

  /// The bounding box of all items.
  Box box() const { return levels_.back().whole(); }

  /// Calls query.meet(begin, end) for the runs of items in boxes that the query reaches, nearer ones first:
  /// query.nearest(BoxLanes) tells a lower bound of the distance of each of eight boxes, at least 0, and
  /// query.reaches(distance) whether an item as near as that may be asked for.
  template <class Query>
  void search(Query& query) const;

 private:
  /// Boxes per parallel block: so many that the boxes of one brush event are one block, which takes less time
  /// than waking another thread.
  static constexpr std::size_t boxes_per_block = 4096;

  struct Node {
    float nearest;
    Index level, index;
  };
  /// A stack deep enough for 2^32 items.
  using Stack = std::array<Node, 10 * fan>;

  void fit(std::size_t level, std::size_t index);
  template <class Query>
  std::size_t push_children(const Node& parent, const Query& query, Stack& stack, std::size_t size) const;

  Items items_;
  std::vector<LanedBoxes> levels_;        ///< of the nodes: leaves first, the last level has one box
  std::vector<Index> touched_;            ///< nodes of one level to be updated
  std::vector<std::uint8_t> is_touched_;  ///< [leaf] all 0 between updates
};

template <class Items>
BoxTree<Items>::BoxTree(Items items) : items_(std::move(items)) {
  std::size_t nodes = items_.size();
  do {
    nodes = (nodes + fan - 1) / fan;
    levels_.emplace_back(nodes);
    parallel_blocks(nodes, boxes_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t index = begin; index < end; ++index) fit(levels_.size() - 1, index);
    });
  } while (nodes > 1);
  is_touched_.resize(levels_.front().size());
}

template <class Items>
void BoxTree<Items>::fit(std::size_t level, std::size_t index) {
  Box box;
  if (level > 0)
    box = levels_[level - 1].run(index).whole();
  else
    for (std::size_t i = index * fan; i < std::min((index + 1) * fan, items_.size()); ++i)
      items_.extend(box, static_cast<Index>(i));
  levels_[level].set(index, box);
}

template <class Items>
template <class Changed>
void BoxTree<Items>::update(const Changed& changed) {
  touched_.clear();
  for (const Index item : changed)
    if (const auto leaf = static_cast<Index>(item / fan); !is_touched_[leaf]) {
      is_touched_[leaf] = 1;
      touched_.push_back(leaf);
    }
  for (const Index leaf : touched_) is_touched_[leaf] = 0;
  std::ranges::sort(touched_);
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    parallel_blocks(touched_.size(), boxes_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) fit(level, touched_[i]);
    });
    for (Index& node : touched_) node = static_cast<Index>(node / fan);
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  }
}

template <class Items>
template <class Query>
void BoxTree<Items>::search(Query& query) const {
  if (items_.size() == 0) return;
  Stack stack;
  // The node above the last level has no box of its own.
  std::size_t size = push_children({0, static_cast<Index>(levels_.size()), 0}, query, stack, 0);
  while (size > 0) {
    const Node node = stack[--size];
    if (!query.reaches(node.nearest)) continue;
    if (node.level == 0) {
      const std::size_t begin = std::size_t{node.index} * fan;
      query.meet(static_cast<Index>(begin), static_cast<Index>(std::min(begin + fan, items_.size())));
    } else {
      size = push_children(node, query, stack, size);
    }
  }
}

/// Pushes the children that the query reaches; the nearest is on top.
template <class Items>
template <class Query>
std::size_t BoxTree<Items>::push_children(const Node& parent, const Query& query, Stack& stack,
                                          std::size_t size) const {
  const Index level = parent.level - 1;
  const BoxLanes::Lane nearest = query.nearest(levels_[level].run(parent.index));
  const std::size_t first = std::size_t{parent.index} * fan, bottom = size,
                    count = std::min(fan, levels_[level].size() - first);
  for (std::size_t i = 0; i < count; ++i) {
    const float own = nearest[static_cast<Eigen::Index>(i)];
    if (!query.reaches(own)) continue;
    std::size_t at = size++;
    for (; at > bottom && stack[at - 1].nearest < own; --at) stack[at] = stack[at - 1];
    stack[at] = {own, level, static_cast<Index>(first + i)};
  }
  return size;
}

}  // namespace burin
