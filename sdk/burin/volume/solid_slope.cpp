// How steeply the distance to a solid changes in space: by differences over two voxels inside of each block.
#include <burin/base/parallel.h>
#include <burin/math/median.h>
#include <burin/volume/solid.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr int block_side = VoxelBlock::side;

/// Appends the slopes, per voxel's edge, of the voxels whose neighbours are in the block and in the band.
void append_slopes(const VoxelBlock& block, float band, std::vector<float>& slopes) {
  constexpr int strides[] = {block_side * block_side, block_side, 1};
  for (int i = 1; i < block_side - 1; ++i)
    for (int j = 1; j < block_side - 1; ++j)
      for (int k = 1; k < block_side - 1; ++k) {
        const float* at = &block.values[static_cast<std::size_t>((i * block_side + j) * block_side + k)];
        float squared = 0;
        bool known = true;
        for (const int stride : strides) {
          known = known && std::max(std::abs(at[stride]), std::abs(at[-stride])) < band;
          squared += (at[stride] - at[-stride]) * (at[stride] - at[-stride]) / 4;
        }
        if (known) slopes.push_back(std::sqrt(squared));
      }
}

}  // namespace

double median_slope(const StrokeSolid& solid) {
  // Values beyond the band are cut off.
  const auto band = static_cast<float>(VoxelBlock::half_width * solid.voxel());
  std::vector<float> slopes;
  for (const VoxelBlock& block : solid.blocks()) append_slopes(block, band, slopes);
  if (slopes.empty()) return 1;
  return static_cast<double>(math::median(slopes)) / solid.voxel();
}

}  // namespace burin
