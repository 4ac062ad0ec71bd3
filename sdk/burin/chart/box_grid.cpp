// Builds the grid by counting sort: the boxes of each cell are counted, then listed in consecutive memory.
#include <burin/chart/box_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace burin {

BoxGrid::BoxGrid(std::span<const Eigen::AlignedBox2d> boxes) {
  boxes_.offsets.assign(2, 0);
  if (boxes.empty()) return;
  Eigen::AlignedBox2d all;
  Vec2d sizes = Vec2d::Zero();
  for (const Eigen::AlignedBox2d& box : boxes) {
    all.extend(box);
    sizes += box.sizes();
  }
  const auto count = static_cast<double>(boxes.size());
  begin_ = all.min();
  for (int axis = 0; axis < 2; ++axis) {
    const double extent = all.sizes()[axis], size = std::max(sizes[axis] / count, extent / std::sqrt(count));
    if (!(size > 0)) continue;
    cell_[axis] = size;
    cells_[static_cast<std::size_t>(axis)] = static_cast<Index>(extent / size) + 1;
  }

  const Vec2d slack = 1e-9 * all.sizes();
  const auto for_each_cell = [&](const Eigen::AlignedBox2d& box, const auto& visit) {
    const auto from = cell_of(box.min() - slack), to = cell_of(box.max() + slack);
    for (Index row = from[1]; row <= to[1]; ++row) {
      for (Index column = from[0]; column <= to[0]; ++column) visit(row * cells_[0] + column);
    }
  };
  auto& offsets = boxes_.offsets;
  offsets.assign(std::size_t{cells_[0]} * cells_[1] + 1, 0);
  for (const auto& box : boxes) for_each_cell(box, [&](Index cell) { ++offsets[cell + 1]; });
  std::inclusive_scan(offsets.begin(), offsets.end(), offsets.begin());
  boxes_.items.resize(offsets.back());
  std::vector<Index> next = offsets;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for_each_cell(boxes[i], [&](Index cell) { boxes_.items[next[cell]++] = static_cast<Index>(i); });
}

std::span<const Index> BoxGrid::around(const Vec2d& place) const {
  const auto [column, row] = cell_of(place);
  return boxes_[row * cells_[0] + column];
}

/// Points outside the grid are clamped to its border cells. The cell is monotone in each coordinate, which
/// the listing of boxes relies on.
std::array<Index, 2> BoxGrid::cell_of(const Vec2d& place) const {
  const auto on = [&](int axis) {
    const double last = static_cast<double>(cells_[static_cast<std::size_t>(axis)] - 1);
    return static_cast<Index>(std::clamp((place[axis] - begin_[axis]) / cell_[axis], 0., last));
  };
  return {on(0), on(1)};
}

}  // namespace burin
