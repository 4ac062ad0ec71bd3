// Sorts points along a 3-D Hilbert curve: curve positions by Skilling's method, then a radix sort, on all
// threads. Costs O(n) time and eight bytes per point besides the result.
#include <burin/base/counting_sort.h>
#include <burin/base/parallel.h>
#include <burin/base/trees/bounding_box.h>
#include <burin/base/trees/spatial_order.h>

#include <algorithm>
#include <array>
#include <bit>

namespace burin {
namespace {

constexpr std::size_t points_per_block = 16384;

/// The number of cells encoded together, in loops that compilers turn into vector instructions.
constexpr std::size_t lanes = 16;
using Cells = std::array<std::array<std::uint32_t, lanes>, 3>;  ///< [axis][lane]

/// Spreads the lowest 21 bits so that two zeros follow each.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

/// Positions along a 3-D Hilbert curve with 2^bits cells per side. This is AxestoTranspose of J. Skilling,
/// "Programming the Hilbert curve", AIP Conference Proceedings 707 (2004): where a bit of an axis is set, the
/// lower bits of the first axis are flipped; where it is not set, they are exchanged with those of the axis.
std::array<std::uint64_t, lanes> hilbert_codes(Cells cells, int bits) {
  auto& [x, y, z] = cells;
  for (int bit = bits - 1; bit > 0; --bit) {
    const std::uint32_t low = (1u << bit) - 1;
    for (std::size_t i = 0; i < lanes; ++i) {
      x[i] ^= low & (0 - (x[i] >> bit & 1));
      const std::uint32_t flips_y = 0 - (y[i] >> bit & 1), swapped_y = (x[i] ^ y[i]) & low & ~flips_y;
      x[i] ^= (low & flips_y) | swapped_y;
      y[i] ^= swapped_y;
      const std::uint32_t flips_z = 0 - (z[i] >> bit & 1), swapped_z = (x[i] ^ z[i]) & low & ~flips_z;
      x[i] ^= (low & flips_z) | swapped_z;
      z[i] ^= swapped_z;
    }
  }
  std::array<std::uint64_t, lanes> codes{};
  for (std::size_t i = 0; i < lanes; ++i) {
    y[i] ^= x[i];
    z[i] ^= y[i];
    std::uint32_t flip = z[i] >> 1;  // becomes the parity of all higher bits
    for (int shift = 1; shift < 32; shift *= 2) flip ^= flip >> shift;
    codes[i] = spread(x[i] ^ flip) << 2 | spread(y[i] ^ flip) << 1 | spread(z[i] ^ flip);
  }
  return codes;
}

/// Maps the bounding box to integer cells. It uses doubles, since a box of finite floats may exceed the range
/// of floats.
class Grid {
 public:
  Grid(std::span<const Vec3f> points, int bits) : bits_(bits) {
    const Eigen::AlignedBox3f box = bounding_box(points);
    corner_ = box.min().cast<double>();
    const double width = (box.max().cast<double>() - corner_).maxCoeff();
    cells_per_unit_ = width > 0 ? (std::ldexp(1, bits) - 1) / width : 0;
  }

  /// The curve positions of up to `lanes` points.
  std::array<std::uint64_t, lanes> codes(std::span<const Vec3f> points) const {
    Cells cells{};
    for (std::size_t lane = 0; lane < points.size(); ++lane)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        cells[axis][lane] =
            static_cast<std::uint32_t>((double{points[lane][i]} - corner_[i]) * cells_per_unit_);
      }
    return hilbert_codes(cells, bits_);
  }

 private:
  int bits_;
  Vec3d corner_;
  double cells_per_unit_;
};

}  // namespace

std::vector<Index> spatial_order(std::span<const Vec3f> points) {
  if (points.empty()) return {};
  // Curve position and index share one word, which halves the memory.
  const int index_bits = std::max(1, static_cast<int>(std::bit_width(points.size() - 1)));
  const int bits = std::min(21, (64 - index_bits) / 3);
  const Grid grid(points, bits);
  UnsetVector<std::uint64_t> keys(points.size());
  parallel_blocks(points.size(), points_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t first = begin; first < end; first += lanes) {
      const std::span<const Vec3f> together = points.subspan(first, std::min(lanes, end - first));
      const std::array<std::uint64_t, lanes> codes = grid.codes(together);
      for (std::size_t lane = 0; lane < together.size(); ++lane)
        keys[first + lane] = codes[lane] << index_bits | (first + lane);
    }
  });
  radix_sort(keys, index_bits, index_bits + 3 * bits);

  const std::uint64_t index_mask = (std::uint64_t{1} << index_bits) - 1;
  std::vector<Index> order(points.size());
  parallel_blocks(points.size(), points_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) order[i] = static_cast<Index>(keys[i] & index_mask);
  });
  return order;
}

}  // namespace burin
