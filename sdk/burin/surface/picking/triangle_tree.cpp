#include <burin/base/parallel.h>
#include <burin/surface/picking/triangle_tree.h>

namespace burin {
namespace {

/// Boxes per parallel block: so many that the boxes of one brush event are one block, which takes less time
/// than waking another thread.
constexpr std::size_t boxes_a_block = 4096;

}  // namespace

TriangleTree::TriangleTree(const Surface& surface) : surface_(surface) {
  std::size_t below = surface.triangles.size();
  do {
    below = (below + fan - 1) / fan;
    levels_.emplace_back(below);
    parallel_blocks(below, boxes_a_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t index = begin; index < end; ++index) fit(levels_.size() - 1, index);
    });
  } while (below > 1);
  is_touched_.resize(levels_.front().size());
}

void TriangleTree::fit(std::size_t level, std::size_t index) {
  Box box;
  const auto run = [&](const auto& items) {
    return std::span(items).subspan(index * fan, std::min(fan, items.size() - index * fan));
  };
  if (level == 0) {
    for (const Triangle& triangle : run(surface_.triangles))
      for (const Index corner : triangle) box.extend(surface_.positions[corner]);
  } else {
    for (const Box& child : run(levels_[level - 1])) box.extend(child);
  }
  levels_[level][index] = box;
}

void TriangleTree::update(std::span<const Index> moved_vertices) {
  touched_.clear();
  for (const Index vertex : moved_vertices)
    for (const Index triangle : surface_.incident[vertex])
      if (const auto leaf = static_cast<Index>(triangle / fan); !is_touched_[leaf]) {
        is_touched_[leaf] = 1;
        touched_.push_back(leaf);
      }
  for (const Index leaf : touched_) is_touched_[leaf] = 0;
  std::ranges::sort(touched_);
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    parallel_blocks(touched_.size(), boxes_a_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) fit(level, touched_[i]);
    });
    for (Index& node : touched_) node = static_cast<Index>(node / fan);
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  }
}

}  // namespace burin
