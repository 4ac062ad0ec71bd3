// The closing of a level set by a ball [J. Serra, Image Analysis and Mathematical Morphology, 1982]: the
// middles of balls outside of the surface are where the distance is at least the radius, and what is farther
// than the radius from all of these is closed. Both distances come by sweeping.
#include <burin/base/parallel.h>
#include <burin/level_set/grid/closed.h>
#include <openvdb/tools/FastSweeping.h>
#include <openvdb/tree/LeafManager.h>

#include <algorithm>

namespace burin {

void close(Grid& grid, double radius) {
  constexpr double rounding = 0.1;  // voxels, of both sweeps
  const double voxel = grid.voxelSize().x();
  const auto far = static_cast<float>(radius * voxel),
             beyond = static_cast<float>((radius + rounding) * voxel);
  const Grid::Ptr distances = openvdb::tools::sdfToSdf(grid);
  const Grid::Ptr from_balls = openvdb::tools::sdfToSdf(*distances, far);
  openvdb::tree::LeafManager<Grid::TreeType> leaves(grid.tree());
  parallel_blocks(leaves.leafCount(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      auto& leaf = leaves.leaf(i);
      const auto* other = from_balls->tree().probeConstLeaf(leaf.origin());
      if (!other) continue;
      for (auto value = leaf.beginValueOn(); value; ++value)
        if (other->isValueOn(value.pos()))
          value.setValue(std::min(*value, other->getValue(value.pos()) + beyond));
    }
  });
}

}  // namespace burin
