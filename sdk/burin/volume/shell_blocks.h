#pragma once
#include <burin/volume/shell.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The blocks that prisms reach into, each with those that do.
class ShellBlocks {
 public:
  /// Throws Error where the voxels would take more than `most_bytes`, before it takes memory for them.
  ShellBlocks(std::span<const Prism> prisms, double h_min, double h_max, double voxel,
              std::size_t most_bytes);

  std::size_t size() const { return begins_.empty() ? 0 : begins_.size() - 1; }

  /// Of a block, in voxels.
  Eigen::Vector3i origin(std::size_t block) const;

  /// Numbers of the prisms that reach into a block, ascending.
  std::span<const Index> prisms(std::size_t block) const {
    return std::span(prisms_).subspan(begins_[block], begins_[block + 1] - begins_[block]);
  }

 private:
  std::vector<std::uint64_t> keys_;  ///< [block]
  std::vector<std::size_t> begins_;
  std::vector<Index> prisms_;
};

}  // namespace burin
