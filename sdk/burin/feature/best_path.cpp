// The globally best path across an image, by dynamic programming: the best score up to each pixel of a column
// is that of the best of five pixels of the column before.
#include <burin/feature/best_path.h>
#include <burin/math/elementary.h>
#include <burin/math/median.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace burin {
namespace {

constexpr double score_of_unknown = -0.25;

/// The known values of a column.
std::vector<float> known_values(const LevelImage& level, int column) {
  std::vector<float> values;
  for (int row = 0; row < level.grid.rows; ++row)
    if (!std::isnan(level.at(column, row))) values.push_back(level.at(column, row));
  return values;
}

/// The distance, in pixels, from the zero crossing of the plane that touches the level at a pixel.
double distance_to_zero(const LevelImage& level, int column, int row) {
  const ChartGrid& grid = level.grid;
  const auto at = [&](int i, int j) {
    return static_cast<double>(
        level.at(std::clamp(column + i, 0, grid.columns - 1), std::clamp(row + j, 0, grid.rows - 1)));
  };
  const double slope = math::hypot(at(1, 0) - at(-1, 0), at(0, 1) - at(0, -1)) / 2;
  return slope > 0 ? std::abs(at(0, 0)) / slope : std::numeric_limits<double>::infinity();
}

/// The scores of the best paths up to the pixels of a column, and their steps from the column before.
class PathTable {
 public:
  PathTable(const LevelImage& score, const PathCosts& costs) : score_(score), costs_(costs) {}

  void start(int column) {
    best_.resize(static_cast<std::size_t>(score_.grid.rows));
    for (int row = 0; row < score_.grid.rows; ++row) best_[static_cast<std::size_t>(row)] = gain(column, row);
  }

  void extend(int column) {
    const int rows = score_.grid.rows;
    std::vector<double> next(best_.size());
    for (int row = 0; row < rows; ++row) {
      double best = -std::numeric_limits<double>::infinity();
      int best_step = 0;
      for (const int step : {0, -1, 1, -2, 2}) {
        if (row - step < 0 || row - step >= rows) continue;
        const double total = best_[static_cast<std::size_t>(row - step)] - costs_.steepness * step * step;
        if (total > best) best = total, best_step = step;
      }
      next[static_cast<std::size_t>(row)] = best + gain(column, row);
      steps_.push_back(static_cast<std::int8_t>(best_step));
    }
    best_.swap(next);
  }

  std::vector<int> trace_back() const {
    const auto rows = best_.size();
    std::vector<int> path(steps_.size() / rows + 1);
    path.back() = static_cast<int>(std::ranges::max_element(best_) - best_.begin());
    for (std::size_t i = path.size() - 1; i > 0; --i)
      path[i - 1] = path[i] - steps_[(i - 1) * rows + static_cast<std::size_t>(path[i])];
    return path;
  }

 private:
  double gain(int column, int row) const {
    const float score = score_.at(column, row);
    const double share = score_.grid.d(row) / score_.grid.d(score_.grid.rows - 1);
    return (std::isnan(score) ? score_of_unknown : static_cast<double>(score)) -
           costs_.closeness * share * share;
  }

  const LevelImage& score_;
  const PathCosts& costs_;
  std::vector<double> best_;        ///< [row] of the last column
  std::vector<std::int8_t> steps_;  ///< [column but the first][row] rows from the column before
};

}  // namespace

LevelImage crest_score(const LevelImage& level) {
  LevelImage result = level;
  double sum = 0;
  int count = 0;
  for (int column = 0; column < level.grid.columns; ++column) {
    std::vector<float> values = known_values(level, column);
    if (values.empty()) continue;
    const float middle = math::median(values);
    sum += static_cast<double>(std::ranges::max(values) - middle);
    ++count;
    for (int row = 0; row < level.grid.rows; ++row) result.values[level.grid.pixel(column, row)] -= middle;
  }
  constexpr float least = -1, most = 2;  // so that no single spike decides
  const auto factor = sum > 0 ? static_cast<float>(count / sum) : 0;
  for (float& value : result.values) {
    // A comparison with NaN is false, so unknown pixels stay as they are.
    value *= factor;
    if (value < least) value = least;
    if (value > most) value = most;
  }
  return result;
}

LevelImage crossing_score(const LevelImage& level, double reach) {
  LevelImage result = level;
  for (int column = 0; column < level.grid.columns; ++column) {
    for (int row = 0; row < level.grid.rows; ++row) {
      float& value = result.values[level.grid.pixel(column, row)];
      if (std::isnan(value)) continue;
      const double share = std::min(distance_to_zero(level, column, row) / reach, 1.0);
      value = std::isnan(share) ? value * 0 : static_cast<float>(1 - share * share);
    }
  }
  return result;
}

std::vector<int> best_path(const LevelImage& score, int first, int count, const PathCosts& costs) {
  PathTable table(score, costs);
  table.start(first);
  for (int i = 1; i < count; ++i) table.extend(first + i);
  return table.trace_back();
}

}  // namespace burin
