#pragma once
#include <burin/base/vector.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace burin {

/// The neighbourhood of a set of points, as a set of cubic cells. add() costs 125 insertions at most, holds()
/// one look-up.
class CellSet {
 public:
  /// The set holds every point within `distance` of an added point, and some more, all within 2.6 times that.
  explicit CellSet(double distance) : cells_per_unit_(cells_per_distance / distance) {}

  void add(const Vec3f& point) {
    const Cell cell = cell_of(point);
    if (!taken_.insert(key(cell)).second) return;
    for (int x = -cells_per_distance; x <= cells_per_distance; ++x)
      for (int y = -cells_per_distance; y <= cells_per_distance; ++y)
        for (int z = -cells_per_distance; z <= cells_per_distance; ++z)
          near_.insert(key({cell[0] + x, cell[1] + y, cell[2] + z}));
  }

  bool holds(const Vec3f& point) const { return near_.contains(key(cell_of(point))); }

 private:
  static constexpr int cells_per_distance = 2;
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Vec3f& point) const {
    Cell cell{};
    for (int i = 0; i < 3; ++i)
      cell[static_cast<std::size_t>(i)] =
          static_cast<std::int64_t>(std::floor(static_cast<double>(point[i]) * cells_per_unit_));
    return cell;
  }
  /// Cells whose coordinates differ by multiples of 2^21 share a key; the set then holds more than it must,
  /// which is harmless.
  static std::uint64_t key(const Cell& cell) {
    std::uint64_t key = 0;
    for (const std::int64_t i : cell) key = key << 21U | (static_cast<std::uint64_t>(i) & 0x1fffffU);
    return key;
  }

  double cells_per_unit_;
  std::unordered_set<std::uint64_t> taken_, near_;
};

}  // namespace burin
