// Significance of a path: contrast over noise. Costs O(pixels).
#include <burin/feature/significance.h>
#include <burin/math/median.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace burin {
namespace {

std::optional<double> median_of_any(std::vector<float>& values) {
  return values.empty() ? std::nullopt : std::optional<double>(static_cast<double>(math::median(values)));
}

/// The greatest difference of known levels.
double range_of(const LevelImage& level) {
  float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
  for (const float value : level.values) {
    if (value < least) least = value;
    if (value > most) most = value;
  }
  return most > least ? static_cast<double>(most) - static_cast<double>(least) : 0;
}

/// The standard deviation of the level's noise; of levels without any, a small share of their range.
double noise_of(const LevelImage& level, int apart) {
  const ChartGrid& grid = level.grid;
  std::vector<float> differences;
  for (int column = 0; column + 3 * apart < grid.columns; ++column) {
    for (int row = 0; row < grid.rows; ++row) {
      const auto at = [&](int steps) { return level.at(column + steps * apart, row); };
      const float difference = at(0) - 3 * at(1) + 3 * at(2) - at(3);
      if (!std::isnan(difference)) differences.push_back(std::abs(difference));
    }
  }
  constexpr double deviations_per_median = 1.4826;  // of normally distributed values
  // The variance of these differences of values whose correlation over k such distances is exp(-k^2).
  constexpr double variance = 20 - 30 * 0.36788 + 12 * 0.01832 - 2 * 0.00012;
  constexpr double least_share = 1e-5;
  return std::max(median_of_any(differences).value_or(0) * deviations_per_median / std::sqrt(variance),
                  least_share * range_of(level));
}

/// The level between the rows of a column; NaN where it is not known.
double level_at(const LevelImage& level, int column, double row) {
  const double below = std::floor(std::clamp(row, 0., level.grid.rows - 1.));
  const int at = static_cast<int>(below), next = std::min(at + 1, level.grid.rows - 1);
  const double share = std::clamp(row - below, 0., 1.);
  return (1 - share) * static_cast<double>(level.at(column, at)) +
         share * static_cast<double>(level.at(column, next));
}

/// The median of the known levels of the rows [from, to) of a column, if there are several.
std::optional<double> side_of(const LevelImage& level, int column, double from, double to) {
  constexpr std::size_t fewest = 3;
  std::vector<float> values;
  const int end = static_cast<int>(std::min(std::ceil(to), static_cast<double>(level.grid.rows)));
  for (int row = static_cast<int>(std::max(std::ceil(from), 0.)); row < end; ++row)
    if (!std::isnan(level.at(column, row))) values.push_back(level.at(column, row));
  return values.size() < fewest ? std::nullopt : median_of_any(values);
}

double crest_contrast(const LevelImage& level, int column, double row, const ContrastWindow& window) {
  const double top = level_at(level, column, row);
  auto right = side_of(level, column, 0, row - window.beside + 1);
  auto left = side_of(level, column, row + window.beside, level.grid.rows);
  if (window.one_side_is_enough) {
    if (!right) right = left;
    if (!left) left = right;
  }
  if (std::isnan(top) || !right || !left) return 0;
  return std::max(0., top - std::max(*right, *left));
}

}  // namespace

std::vector<double> crest_contrasts(const LevelImage& level, std::span<const double> path, int first,
                                    const ContrastWindow& window) {
  const double noise = noise_of(level, window.apart);
  std::vector<double> result(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double contrast = crest_contrast(level, first + static_cast<int>(i), path[i], window);
    result[i] = contrast > 0 && noise > 0 ? contrast / noise : 0;
  }
  return result;
}

std::vector<double> levels_on(const LevelImage& level, std::span<const double> path, int first) {
  std::vector<double> result(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double value = level_at(level, first + static_cast<int>(i), path[i]);
    result[i] = std::isnan(value) ? 0 : value;
  }
  return result;
}

std::vector<double> means_along(std::span<const double> values, double places) {
  std::vector<double> sums = {0};  // [i] sum of the values before i
  for (const double value : values) sums.push_back(sums.back() + value);
  std::vector<double> result(values.size());
  const auto along = static_cast<std::size_t>(std::lround(places));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t begin = i - std::min(i, along), end = std::min(i + along + 1, values.size());
    result[i] = (sums[end] - sums[begin]) / static_cast<double>(end - begin);
  }
  return result;
}

}  // namespace burin
