#pragma once
#include <burin/feature/sampled_feature.h>

#include <span>
#include <vector>

namespace burin {

/// What the path of a feature is in one column of an image.
struct PathColumn {
  double row = 0;  ///< pixels
  /// Of crests, their contrast in units of the noise; of silhouettes, the scale over the standard error of
  /// their place; of borders, six times the share of them that is there. Averaged along the path.
  double significance = 0;
  double place = 0;  ///< row where a fit places the feature, before smoothing
  bool has_place = false;
};

/// Columns of an image.
struct ColumnRange {
  int first = 0, count = 0;
};

/// How a path is searched for.
struct PathSearch {
  Smoothing smoothing;              ///< of the image, pixels
  double window = 10;               ///< columns to either side over which significance is averaged
  int fits = 2;                     ///< of each place; the second is centred on the first one's result
  bool one_side_is_enough = false;  ///< see ContrastWindow
  double bridged = 3;  ///< farthest that columns count as found from one that was placed, deviations
  double stiff = 1;    ///< waves of the path shorter than 2 pi times this are flattened, columns
  /// Second differences of the stroke's positions at the columns, to the left, rows; see smooth_offsets().
  std::span<const double> bends;
};

/// Finds the path of a feature in these columns of its image.
std::vector<PathColumn> find_path(const SampledFeature& sampled, const ColumnRange& columns,
                                  const PathSearch& search);

}  // namespace burin
