#pragma once
#include <burin/feature/sampled_feature.h>

#include <span>
#include <vector>

namespace burin {

/// What the path of a feature is in one column of an image.
struct PathColumn {
  double row = 0;           ///< pixels
  double significance = 0;  ///< see significance()
};

/// Columns of an image.
struct ColumnRange {
  int first = 0, count = 0;
};

/// How a path is searched for.
struct PathSearch {
  Smoothing smoothing;              ///< of the image, pixels
  double window = 10;               ///< columns to either side over which significance is averaged
  bool one_side_is_enough = false;  ///< see SignificanceWindow
  double stiff = 1;                 ///< waves of the path shorter than 2 pi times this are flattened, columns
  /// Second differences of the stroke's positions at the columns, to the left, rows; see smooth_offsets().
  std::span<const double> bends;
};

/// Finds the path of a feature in these columns of its image.
std::vector<PathColumn> find_path(const SampledFeature& sampled, const ColumnRange& columns,
                                  const PathSearch& search);

}  // namespace burin
