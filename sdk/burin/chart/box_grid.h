#pragma once
#include <burin/base/vector.h>
#include <burin/surface/csr.h>

#include <Eigen/Geometry>
#include <array>
#include <span>

namespace burin {

/// Finds the boxes of a plane that hold a place: each is listed in the cells of a uniform grid that it
/// touches. The cells are as large as the boxes are on average, and no more than these: n boxes take time and
/// memory of O(n) when they are of like size, and of O(n^1.5) at worst.
class BoxGrid {
 public:
  BoxGrid() : BoxGrid(std::span<const Eigen::AlignedBox2d>()) {}
  explicit BoxGrid(std::span<const Eigen::AlignedBox2d> boxes);

  /// Numbers, ascending, of boxes about the place, among them all that hold it, or miss it by no more than
  /// 1e-9 of the extent of all boxes. Any thread, concurrent.
  std::span<const Index> around(const Vec2d& place) const;

 private:
  std::array<Index, 2> cell_of(const Vec2d& place) const;

  Vec2d begin_ = Vec2d::Zero(), cell_ = Vec2d::Ones();
  std::array<Index, 2> cells_ = {1, 1};
  Csr boxes_;  ///< [cell, row by row]
};

}  // namespace burin
