#pragma once
#include <burin/base/vector.h>
#include <burin/surface/csr.h>

#include <Eigen/Geometry>
#include <array>
#include <span>

namespace burin {

/// Finds the axis-aligned boxes that hold a point of the plane. A uniform grid lists each box in every cell
/// that it touches. Cells have the average size of the boxes, and there are at most as many cells as boxes: n
/// boxes take O(n) time and memory when their sizes are similar, and O(n^1.5) in the worst case.
class BoxGrid {
 public:
  BoxGrid() : BoxGrid(std::span<const Eigen::AlignedBox2d>()) {}
  explicit BoxGrid(std::span<const Eigen::AlignedBox2d> boxes);

  /// Returns indices of boxes near the point, ascending. All boxes that hold the point, or miss it by at most
  /// 1e-9 of the extent of all boxes, are among them. May be called from several threads at once.
  std::span<const Index> around(const Vec2d& place) const;

 private:
  std::array<Index, 2> cell_of(const Vec2d& place) const;

  Vec2d begin_ = Vec2d::Zero(), cell_ = Vec2d::Ones();
  std::array<Index, 2> cells_ = {1, 1};
  Csr boxes_;  ///< [cell in row-major order] indices of the boxes that touch it
};

}  // namespace burin
