#pragma once
#include <burin/feature/snap.h>

#include <vector>

namespace burin {

/// A line of a surface that is followed while the view or the surface changes.
struct TrackedLine {
  SurfaceCurve curve;
  /// [point of the curve] the arc length, on the curve with which tracking started, of the point that became
  /// this one, object units; ascending. That of a closed curve goes on beyond its end.
  std::vector<double> start_t;
  double start_length = 0;  ///< of a closed curve with which tracking started; 0 if that one was open
};

/// Why a part of a line is not followed any further.
enum class LossKind {
  ended,   ///< the feature is no longer there, up to an end of an open line
  split,   ///< it is no longer there between two parts where it is, or on a closed line
  jumped,  ///< what is there is farther away than TrackOptions::most_edges, so another line
};

/// A part of a line that is not followed any further.
struct Loss {
  LossKind kind = LossKind::ended;
  double from = 0, to = 0;  ///< arc lengths on the line before, object units; on closed ones `to` may be
                            ///< beyond the length
};

/// How lines are followed.
struct TrackOptions {
  /// As the line was snapped. Of the radius at most four scales are used, since the feature is near.
  SnapOptions snap;
  double most_edges = 2;  ///< greatest move of a point in one step, typical edges in reach, > 0
};

/// What one step of tracking made of a line.
struct TrackStep {
  std::vector<TrackedLine> lines;  ///< the parts that are followed, in the order of the line before
  std::vector<Loss> losses;        ///< ascending
  double most_moved = 0;           ///< greatest move of a point that is followed, object units
  SnapResult snapped;              ///< of the whole line
};

/// Follows features from one view, or one state of a surface, to the next, which differs a little. The line
/// of the step before is carried to the surface as it is now and snapped from there, so that it stays on its
/// own feature where others are stronger. A point corresponds to the one that it came from by moving at right
/// angles to the line; so identities last over a sequence. A call costs as much as that of StrokeSnapper.
/// One thread at a time.
class LineTracker {
 public:
  /// The surface as it is now, and its picker, which must outlive the object. Throws ContractError for a
  /// point set.
  LineTracker(const Surface& surface, const Picker& picker);

  /// Follows a line. The line's points keep their places in their triangles if the surface has the same
  /// triangles as the one that the line was on; else they move to the closest point of the surface, and the
  /// whole line ends if that is farther away than the radius. Throws the ContractErrors of
  /// StrokeSnapper::snap(), also if most_edges is not above 0 or `start_t` has another number of elements
  /// than the curve has points.
  TrackStep follow(const TrackedLine& before, const Feature& feature, const TrackOptions& options);

 private:
  const Surface& surface_;
  const Picker& picker_;
  StrokeSnapper snapper_;
};

/// A snapped stroke, to be tracked from now on.
TrackedLine tracked(const SurfaceCurve& curve);

}  // namespace burin
