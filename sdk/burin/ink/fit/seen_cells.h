#pragma once
#include <burin/stroke/camera.h>

#include <cstdint>
#include <vector>

namespace burin {

/// A set of cells of a grid, as rows of bits.
class CellSet {
 public:
  CellSet(int columns, int rows, bool filled);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool has(int column, int row) const;
  void set(int column, int row, bool value);
  bool empty() const;

  /// Keeps the cells from which the cell so many columns and rows on is in the other set.
  void keep_where(const CellSet& other, int columns_on, int rows_on);

 private:
  std::uint64_t* row_of(int row) { return words_.data() + static_cast<std::size_t>(row) * row_words_; }
  const std::uint64_t* row_of(int row) const {
    return words_.data() + static_cast<std::size_t>(row) * row_words_;
  }

  int columns_, rows_;
  std::size_t row_words_;
  std::vector<std::uint64_t> words_;
};

/// The edge of the cells into which seen_cells() divides a camera's viewport, pixels.
double cell_size(const Camera& camera);

/// The cells of the viewport in which the camera sees the surface, whole and not too steep: from corner to
/// corner it goes at most 4 times as far away as aside, so that it has no step there.
CellSet seen_cells(const Camera& camera, const Picker& picker);

}  // namespace burin
