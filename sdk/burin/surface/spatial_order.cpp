#include <burin/base/parallel.h>
#include <burin/surface/spatial_order.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>

namespace burin {
namespace {

constexpr std::size_t points_a_block = 16384;

/// Position along a 3D Hilbert curve of 2^bits cells to a side.
/// J. Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707 (2004): AxestoTranspose.
std::uint64_t hilbert_code(std::array<std::uint32_t, 3> cell, int bits) {
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1) {
    const std::uint32_t low = q - 1;
    for (std::uint32_t& axis : cell) {
      if (axis & q) {
        cell[0] ^= low;
      } else {
        const std::uint32_t swapped = (cell[0] ^ axis) & low;
        cell[0] ^= swapped;
        axis ^= swapped;
      }
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t flip = 0;
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1)
    if (cell[2] & q) flip ^= q - 1;
  std::uint64_t code = 0;
  for (int bit = bits - 1; bit >= 0; --bit)
    for (const std::uint32_t axis : cell) code = code << 1 | (((axis ^ flip) >> bit) & 1);
  return code;
}

/// Maps the bounding box to whole cells. Doubles: the box of finite floats may be wider than a float.
class Grid {
 public:
  Grid(std::span<const Vec3f> points, int bits) : bits_(bits) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& point : points) box.extend(point);
    corner_ = box.min().cast<double>();
    const double width = (box.max().cast<double>() - corner_).maxCoeff();
    cells_per_unit_ = width > 0 ? (std::exp2(bits) - 1) / width : 0;
  }

  std::uint64_t code(const Vec3f& point) const {
    const Vec3d cell = (point.cast<double>() - corner_) * cells_per_unit_;
    return hilbert_code({static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y()),
                         static_cast<std::uint32_t>(cell.z())},
                        bits_);
  }

 private:
  int bits_;
  Vec3d corner_;
  double cells_per_unit_;
};

}  // namespace

std::vector<Index> spatial_order(std::span<const Vec3f> points) {
  if (points.empty()) return {};
  // Curve position and index share one word: half the memory of a pair, and every key is unique.
  const int index_bits = std::max(1, static_cast<int>(std::bit_width(points.size() - 1)));
  const Grid grid(points, std::min(21, (64 - index_bits) / 3));
  std::vector<std::uint64_t> keys(points.size());
  parallel_blocks(points.size(), points_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) keys[i] = grid.code(points[i]) << index_bits | i;
  });
  parallel_sort(keys.begin(), keys.end());

  const std::uint64_t index_mask = (std::uint64_t{1} << index_bits) - 1;
  std::vector<Index> order(points.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [&](std::uint64_t key) { return static_cast<Index>(key & index_mask); });
  return order;
}

}  // namespace burin
