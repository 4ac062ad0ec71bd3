#pragma once
#include <burin/feature/level_image.h>

#include <span>
#include <vector>

namespace burin {

/// Where the contrast of a crest is measured, pixels.
struct ContrastWindow {
  double beside = 3;                ///< rows from the path to where its sides begin
  int apart = 8;                    ///< two deviations of the level's smoothing along t, columns
  bool one_side_is_enough = false;  ///< where the level is known on one side only; else contrast is 0 there
};

/// How far a path stands out from what is on either side of it: the level on it less the greater of the
/// medians on both sides, in units of the level's noise, per column of [first, first + path.size()); `path`
/// has its rows. The noise is estimated from third differences along t (after Immerkaer 1996), by their
/// median, which the few pixels of a feature do not change; a feature that runs along the stroke does not
/// count as noise anyway. 0 where the level is not known.
std::vector<double> crest_contrasts(const LevelImage& level, std::span<const double> path, int first,
                                    const ContrastWindow& window);

/// The level on a path, per column; 0 where it is not known.
std::vector<double> levels_on(const LevelImage& level, std::span<const double> path, int first);

/// Means of the values up to so many places away on either side.
std::vector<double> means_along(std::span<const double> values, double places);

}  // namespace burin
