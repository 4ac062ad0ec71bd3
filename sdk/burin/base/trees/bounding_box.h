#pragma once
#include <burin/base/parallel.h>
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// The bounding box of positions, computed on all threads.
inline Eigen::AlignedBox3f bounding_box(std::span<const Vec3f> positions) {
  constexpr std::size_t positions_per_block = 16384;
  std::vector<Eigen::AlignedBox3f> boxes(positions.size() / positions_per_block + 1);
  parallel_blocks(positions.size(), positions_per_block, [&](std::size_t begin, std::size_t end) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& position : positions.subspan(begin, end - begin)) box.extend(position);
    boxes[begin / positions_per_block] = box;
  });
  Eigen::AlignedBox3f whole;
  for (const Eigen::AlignedBox3f& box : boxes) whole.extend(box);
  return whole;
}

inline double bounding_box_diagonal(std::span<const Vec3f> positions) {
  const Eigen::AlignedBox3f box = bounding_box(positions);
  return (box.max().cast<double>() - box.min().cast<double>()).norm();
}

}  // namespace burin
