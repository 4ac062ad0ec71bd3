// Finds the cells of a view where a surface is seen, by a ray through each corner and each middle.
#include <burin/base/parallel.h>
#include <burin/base/vector.h>
#include <burin/ink/fit/seen_cells.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr int cells_along = 256;  // the longer side of the view
constexpr std::size_t bits = 64;

/// What a ray meets.
struct Seen {
  Ray ray;
  std::optional<SurfacePoint> point;
};

using SeenRow = std::vector<Seen>;

/// What is seen through the points of a row of cells; `shift`: 0 at their corners, 0.5 in their middles.
SeenRow seen_row(const Camera& camera, const Picker& picker, int row, int columns, double shift) {
  const double size = cell_size(camera);
  SeenRow seen;
  for (int column = 0; column < columns; ++column) {
    const Ray ray = pixel_ray(camera, (column + shift) * size, (row + shift) * size);
    seen.push_back({ray, picker.pick(ray)});
  }
  return seen;
}

/// Whether the surface goes on from one of two neighbouring points to the other.
bool goes_on(const Seen& a, const Seen& b) {
  constexpr float steepest = 4;
  if (!a.point || !b.point) return false;
  const Vec3f& from = a.point->position;
  const float away = (from - a.ray.origin).norm();
  const float aside = (b.ray.origin + away * b.ray.direction - from).norm();
  return (b.point->position - from).norm() <= std::sqrt(1 + steepest * steepest) * aside;
}

}  // namespace

CellSet::CellSet(int columns, int rows, bool filled)
    : columns_(columns),
      rows_(rows),
      row_words_((static_cast<std::size_t>(columns) + bits - 1) / bits),
      words_(row_words_ * static_cast<std::size_t>(rows)) {
  if (!filled) return;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) set(column, row, true);
}

bool CellSet::has(int column, int row) const {
  const auto at = static_cast<std::size_t>(column);
  return row_of(row)[at / bits] >> at % bits & 1;
}

void CellSet::set(int column, int row, bool value) {
  const auto at = static_cast<std::size_t>(column);
  const std::uint64_t bit = std::uint64_t{1} << at % bits;
  std::uint64_t& word = row_of(row)[at / bits];
  word = value ? word | bit : word & ~bit;
}

bool CellSet::empty() const {
  return std::ranges::all_of(words_, [](std::uint64_t word) { return word == 0; });
}

void CellSet::keep_where(const CellSet& other, int columns_on, int rows_on) {
  const std::size_t words_on = static_cast<std::size_t>(columns_on) / bits;
  const std::size_t bits_on = static_cast<std::size_t>(columns_on) % bits;
  for (int row = 0; row < rows_; ++row) {
    std::uint64_t* const own = row_of(row);
    const std::uint64_t* const from = row + rows_on < rows_ ? other.row_of(row + rows_on) : nullptr;
    for (std::size_t word = 0; word < row_words_; ++word) {
      const std::size_t at = word + words_on;
      std::uint64_t kept = from && at < row_words_ ? from[at] >> bits_on : 0;
      if (from && bits_on > 0 && at + 1 < row_words_) kept |= from[at + 1] << (bits - bits_on);
      own[word] &= kept;
    }
  }
}

double cell_size(const Camera& camera) {
  return static_cast<double>(std::max(camera.width, camera.height)) / cells_along;
}

CellSet seen_cells(const Camera& camera, const Picker& picker) {
  const double size = cell_size(camera);
  const int columns = static_cast<int>(std::floor(camera.width / size));
  const int rows = static_cast<int>(std::floor(camera.height / size));
  std::vector<SeenRow> corners(static_cast<std::size_t>(rows) + 1);
  std::vector<SeenRow> middles(static_cast<std::size_t>(rows));
  parallel_blocks(corners.size(), 1, [&](std::size_t row, std::size_t) {
    corners[row] = seen_row(camera, picker, static_cast<int>(row), columns + 1, 0);
    if (row < middles.size()) middles[row] = seen_row(camera, picker, static_cast<int>(row), columns, 0.5);
  });
  CellSet cells(columns, rows, false);
  for (std::size_t row = 0; row < middles.size(); ++row)
    for (std::size_t column = 0; column < middles[row].size(); ++column) {
      const Seen &a = corners[row][column], &b = corners[row][column + 1];
      const Seen &c = corners[row + 1][column], &d = corners[row + 1][column + 1];
      if (middles[row][column].point && goes_on(a, b) && goes_on(a, c) && goes_on(b, d) && goes_on(c, d))
        cells.set(static_cast<int>(column), static_cast<int>(row), true);
    }
  return cells;
}

}  // namespace burin
