// Finds the blocks of voxels that the prisms of a shell reach into: lists pairs of block and prism, layer by
// layer of each prism, and sorts them by block. Costs time and memory in proportion to the pairs.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/volume/shell_blocks.h>
#include <fmt/format.h>

#include <cmath>

namespace burin {
namespace {

constexpr int bits = 21;
constexpr std::int64_t middle = std::int64_t{1} << (bits - 1);

/// Block coordinates in one number, in lexicographic order.
std::uint64_t key_of(const Eigen::Vector3i& block) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) key = key << bits | static_cast<std::uint64_t>(block[axis] + middle);
  return key;
}

struct Range {
  Eigen::Vector3i first, last;

  std::size_t blocks() const {
    std::size_t count = 1;
    for (int axis = 0; axis < 3; ++axis) count *= static_cast<std::size_t>(last[axis] - first[axis] + 1);
    return count;
  }
};

Range blocks_of(const Eigen::AlignedBox3d& box, double block_size) {
  Range range;
  for (int axis = 0; axis < 3; ++axis) {
    const double first = std::floor(box.min()[axis] / block_size),
                 last = std::floor(box.max()[axis] / block_size);
    if (!(std::abs(first) < static_cast<double>(middle) && std::abs(last) < static_cast<double>(middle)))
      throw Error("the voxel is too small for a surface of this extent");
    range.first[axis] = static_cast<int>(first);
    range.last[axis] = static_cast<int>(last);
  }
  return range;
}

struct Pair {
  std::uint64_t block;
  Index prism;
  auto operator<=>(const Pair&) const = default;
};

void check_memory(std::size_t bytes, std::size_t most_bytes) {
  constexpr std::size_t mega = 1000000;
  if (bytes > most_bytes)
    throw Error(fmt::format(
        "the solid's grid would take {} MB or more, which is above the bound of {} MB: use larger voxels",
        bytes / mega, most_bytes / mega));
}

/// Calls visit(range) with the blocks of a prism, one layer of them after another along its axis. A voxel
/// belongs to the block that holds its middle.
template <class Visit>
void for_each_layer(const Prism& prism, double h_min, double h_max, double voxel, const Visit& visit) {
  const double block_size = VoxelBlock::side * voxel, half = voxel / 2;
  const auto range_of = [&](Eigen::AlignedBox3d box) {
    box.translate(Vec3d::Constant(half));
    return blocks_of(box, block_size);
  };
  const int axis = prism.axis();
  const Range whole = range_of(prism.box(h_min, h_max));
  for (int layer = whole.first[axis]; layer <= whole.last[axis]; ++layer) {
    const double low = layer * block_size - half;
    const Eigen::AlignedBox3d box = prism.layer(h_min, h_max, low, low + block_size);
    if (box.isEmpty()) continue;
    Range range = range_of(box);
    range.first[axis] = range.last[axis] = layer;
    visit(range);
  }
}

}  // namespace

ShellBlocks::ShellBlocks(std::span<const Prism> prisms, double h_min, double h_max, double voxel,
                         std::size_t most_bytes) {
  std::vector<Pair> pairs;
  for (std::size_t prism = 0; prism < prisms.size(); ++prism) {
    const auto add = [&](const Range& range) {
      check_memory((pairs.size() + range.blocks()) * sizeof(Pair), most_bytes);
      for (int x = range.first.x(); x <= range.last.x(); ++x)
        for (int y = range.first.y(); y <= range.last.y(); ++y)
          for (int z = range.first.z(); z <= range.last.z(); ++z)
            pairs.push_back({key_of({x, y, z}), static_cast<Index>(prism)});
    };
    for_each_layer(prisms[prism], h_min, h_max, voxel, add);
  }
  parallel_sort(pairs.begin(), pairs.end());
  for (const Pair& pair : pairs) {
    if (keys_.empty() || keys_.back() != pair.block) {
      keys_.push_back(pair.block);
      begins_.push_back(prisms_.size());
    }
    prisms_.push_back(pair.prism);
  }
  begins_.push_back(prisms_.size());
  // Once as they are filled, once in the grid.
  check_memory(2 * size() * VoxelBlock::voxels * sizeof(float), most_bytes);
}

Eigen::Vector3i ShellBlocks::origin(std::size_t block) const {
  Eigen::Vector3i origin;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t part = keys_[block] >> (bits * (2 - axis)) & ((std::uint64_t{1} << bits) - 1);
    origin[axis] = static_cast<int>((static_cast<std::int64_t>(part) - middle) * VoxelBlock::side);
  }
  return origin;
}

}  // namespace burin
