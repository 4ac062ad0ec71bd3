#pragma once
#include <burin/feature/level_image.h>

#include <vector>

namespace burin {

/// Scores of paths: 1 per column is the mean of the best pixels of the columns.
struct PathCosts {
  double closeness = 0.25;  ///< cost of a column at the rim of the image; grows with the square of d
  double steepness = 0.15;  ///< cost of one row per column; grows with its square
};

/// How well a path would do at each pixel: 0 for the median of a column, 1 for the mean of the columns'
/// greatest values; NaN where the level is not known.
LevelImage crest_score(const LevelImage& level);

/// The same for paths along zero crossings: 1 on them, falling to 0 at `reach` pixels from them.
LevelImage crossing_score(const LevelImage& level, double reach);

/// Returns the row of the path with the greatest total score minus costs in each of the columns [first,
/// first + count). The path is the best of all that go by at most two rows per column, found by dynamic
/// programming [Viterbi 1967] in O(pixels).
std::vector<int> best_path(const LevelImage& score, int first, int count, const PathCosts& costs);

}  // namespace burin
