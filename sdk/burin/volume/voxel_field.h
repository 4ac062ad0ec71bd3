#pragma once
#include <burin/base/vector.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace burin {

/// Which grid of a file to read, and how.
struct VoxelFieldOptions {
  std::string grid;  ///< its name; empty: the first one of floats
  /// The density at the surface of a fog volume that is read as a level set; 0: it stays a fog volume.
  double surface_at = 0;

  bool operator==(const VoxelFieldOptions&) const = default;
};

/// A box of voxels, as a stamp is: distances of a level set, or densities of a fog volume. Blocks of equal
/// values take no memory. Any thread may read it.
class VoxelField {
 public:
  enum class Kind {
    level_set,  ///< signed distances, negative inside
    fog,        ///< densities
  };
  static constexpr std::size_t most_voxels = std::size_t{1} << 28;
  static constexpr int side = 8;  ///< of a block, voxels

  /// Writes the values of the block whose least voxel is at `first`: voxel (i, j, k) of it at 64 i + 8 j + k.
  /// Those of voxels beyond the box are ignored.
  using FillBlock = std::function<void(const Eigen::Vector3i& first, std::array<float, 512>& values)>;

  /// `size`: of the box in voxels, each >= 1, in all at most `most_voxels`; `unit`: the edge of a voxel in
  /// the unit of distances. Calls `fill` for block after block.
  VoxelField(Kind kind, const Eigen::Vector3i& size, double unit, const FillBlock& fill);

  Kind kind() const { return kind_; }
  const Eigen::Vector3i& size() const { return size_; }

  /// The least and the greatest value: distances in voxels, or densities.
  float minimum() const { return minimum_; }
  float maximum() const { return maximum_; }

  /// The value at a point, given in voxels from the least corner of the box: the middle of the first voxel is
  /// at (0.5, 0.5, 0.5). Trilinear between middles. Along a periodic axis the box repeats without an end.
  /// Beyond the others' outermost middles there is no solid and no fog: distances, in voxels, are lower
  /// bounds made of the distance from the box, densities are 0. NaN where a coordinate is not finite.
  float at(const Vec3d& place, const std::array<bool, 3>& periodic) const;

 private:
  /// A block's values start at `first`; all are the same if it is uniform.
  struct Block {
    std::uint32_t first = 0;
    bool uniform = true;
  };
  float voxel(int i, int j, int k) const;
  void add_block(const std::array<float, 512>& values, const Eigen::Vector3i& extent);

  Kind kind_;
  Eigen::Vector3i size_, blocks_along_;
  float per_unit_;  ///< what values are multiplied with to be told in voxels
  float minimum_, maximum_;
  std::vector<Block> blocks_;
  std::vector<float> values_;
};

}  // namespace burin
