#pragma once
#include <burin/feature/level_image.h>

#include <span>
#include <vector>

namespace burin {

/// How far a path stands out from what is on either side of it.
enum class Contrast {
  crest,     ///< the level on the path less the greater of the medians on both sides
  crossing,  ///< the lesser of the levels on both sides, if they have opposite signs; else 0
  absolute,  ///< the level on the path itself, whose noise is 1/6
};

/// Where and over which distances significance is measured, pixels.
struct SignificanceWindow {
  double beside = 3;                ///< rows from the path to where its sides begin
  double along = 10;                ///< columns over which it is averaged, to either side
  int apart = 12;                   ///< columns between values that smoothing does not correlate
  bool one_side_is_enough = false;  ///< where the level is known on one side only; else contrast is 0 there
};

/// The contrast of a path in units of the level's noise, per column of [first, first + path.size()), averaged
/// along the path; `path` has its rows. The noise is estimated from third differences along t (after
/// Immerkaer 1996), by their median, which the few pixels of a feature do not change; a feature that runs
/// along the stroke does not count as noise anyway. 0 where the level is not known.
std::vector<double> significance(const LevelImage& level, Contrast contrast, std::span<const double> path,
                                 int first, const SignificanceWindow& window);

}  // namespace burin
