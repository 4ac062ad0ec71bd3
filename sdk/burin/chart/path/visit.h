#pragma once
#include <burin/chart/path/stroke_samples.h>

namespace burin {

/// A visit of the stroke to a vertex: consecutive samples whose discs all hold the vertex [Schmidt 2013,
/// section 4.1], cut where the stroke moves away from the vertex and comes back. So each part of a hook, a
/// hairpin or a spiral near the vertex has a visit of its own, although the stroke may not leave the disc in
/// between. Visits are a function of the samples and the vertex.
struct Visit {
  Index begin = 0, length = 0;  ///< first sample, and number of samples
  bool ends = false;            ///< its end is final; otherwise samples appended to the stroke may extend it
  /// The last sample that was needed to decide whether the stroke comes back, or the one after the last
  /// sample while that is undecided; no_index when the stroke never started to come back. The samples of the
  /// visit stay the same as long as the stroke's samples up to this one do.
  Index decided_by = no_index;
};

/// The visits to a vertex at `position`, with this normal.
class Visits {
 public:
  /// The samples must outlive the object.
  Visits(const StrokeSamples& samples, const Vec3f& position, const Vec3f& normal)
      : samples_(&samples), position_(position), normal_(normal) {}

  /// Whether the sample belongs to any visit.
  bool any(Index sample) const { return samples_->disc_holds(sample, position_, normal_); }

  /// A visit, and the `decided_by` of the visit before it in the same run.
  struct Found {
    Visit visit;
    Index begin_decided_by = no_index;
  };

  /// Finds the visit of a sample that belongs to one. The search for the start of the run goes back to
  /// `floor` at most, which is 0 or the start of an earlier visit; closed strokes ignore it.
  Found find(Index sample, Index floor) const;

  /// The visit that starts with this sample and has at most `most` samples.
  Visit from(Index begin, Index most = no_index) const;

 private:
  Index run_begin(Index sample, Index floor) const;
  Index farthest() const;
  float distance(Index sample) const { return samples_->chord(sample, position_); }

  const StrokeSamples* samples_;
  Vec3f position_, normal_;
};

}  // namespace burin
