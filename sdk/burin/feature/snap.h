#pragma once
#include <burin/feature/chart_grid.h>
#include <burin/feature/feature.h>
#include <burin/stroke/curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <memory>
#include <vector>

namespace burin {

/// How a stroke is snapped.
struct SnapOptions {
  double radius = 0;  ///< how far from the stroke features are searched for, object units, > 0
  /// Standard deviation of the Gaussian by which the feature's function is smoothed across the stroke, object
  /// units; at most a third of the radius. It should not be much wider than the feature. 0: a sixth of the
  /// radius for ridges, valleys and values, but at least default_edges edges; that many for others.
  double scale = 0;
  int iterations = 2;       ///< charts: the first around the stroke, each other one around the result before
  double significance = 4;  ///< least contrast that counts, in units of the noise; see significance()
  bool fixed_ends = false;  ///< the ends of the stroke stay where they are
  /// The stroke lies along the feature already, less than about two scales away, as that of the step before
  /// does in a sequence. Only four scales to either side are searched, and gaps of the feature longer than
  /// two scales are not bridged; else up to six are.
  bool is_near = false;
};

/// Least default scale, mean edges.
inline constexpr double default_edges = 1.25;

/// A part of a stroke that was snapped to a feature.
struct SnapRange {
  double from = 0, to = 0;  ///< arc lengths on the stroke, object units; on closed ones `to` may be beyond
                            ///< the length
  double significance = 0;  ///< mean
};

/// The image of one iteration with the path found in it.
struct SnapImage {
  LevelImage level;
  int first = 0;             ///< column of the first row
  std::vector<double> rows;  ///< of the path, pixels
};

/// A snapped stroke.
struct SnapResult {
  SurfaceCurve curve;            ///< equals the stroke, bit for bit, if there is no range
  std::vector<double> stroke_t;  ///< [point of the curve] arc length of the corresponding point of the stroke
  std::vector<SnapRange> ranges;  ///< ascending
  double significance = 0;        ///< mean over the ranges; the greatest anywhere if there is none
  double snapped_share = 0;       ///< of the stroke's length
  double mean_move =
      0;  ///< of the points in the ranges from the corresponding points of the stroke, object units
  double scale = 0;               ///< that was used, object units
  double edge = 0;                ///< typical length of edges in reach, object units
  int iterations = 0;             ///< that were made
  std::vector<SnapImage> images;  ///< [iteration]
};

/// Moves strokes to features of a surface [Schmidt 2013, section 6.1]. The chart of the region around the
/// stroke unrolls it to an image of the feature's function over (t, d), in which the globally best path from
/// end to end is found. Local fits to the vertices around the path place it to a small share of an edge, and
/// a smoothing spline weighs them by their precision. The chart takes the path back to the surface; another
/// chart around the result repeats it. Where the path does not stand out from the noise the stroke stays as
/// it is, to the bit. Holds memory in proportion to the surface; a call costs O(n log n) for n vertices in
/// reach, so that it may be called while the pen draws, with the stroke so far. The result has the same bits
/// on any number of threads. One thread at a time.
class StrokeSnapper {
 public:
  /// Surface and picker must outlive the object and must not change. Throws ContractError for a point set.
  StrokeSnapper(const Surface& surface, const Picker& picker);
  ~StrokeSnapper();
  StrokeSnapper(StrokeSnapper&&) noexcept;
  StrokeSnapper& operator=(StrokeSnapper&&) noexcept;

  /// The stroke's curve must lie on the surface itself, not on a base surface. Throws ContractError for a
  /// curve without points, a radius or scale that is not finite or positive, fewer than one iteration, or
  /// values of another number than there are vertices.
  SnapResult snap(const SurfaceCurve& stroke, const Feature& feature, const SnapOptions& options);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace burin
