#pragma once
#include <burin/chart/path/stroke_samples.h>

namespace burin {

/// A visit of the stroke to a vertex: a run of samples whose discs all hold the vertex
/// [Schmidt 2013, section 4.1], cut where the stroke, after it has gone away from the vertex, comes back. So
/// each part of a hook, a hairpin or a spiral that is nearest to the vertex has a visit of its own, though
/// the stroke may not leave the disc in between. Visits are a function of the samples and the vertex.
struct Visit {
  Index begin = 0, length = 0;
  bool ends = false;  ///< surely; or it may go on with samples that come after the last
  /// The last sample by which it was told whether the stroke comes back, or the one after the last when that
  /// is open still; no_index: it never looked like it. As long as samples up to there stay, so do those of
  /// the visit.
  Index told_by = no_index;
};

/// The visits to a vertex at `position`, with this normal.
class Visits {
 public:
  /// The samples must outlive the object.
  Visits(const StrokeSamples& samples, const Vec3f& position, const Vec3f& normal)
      : samples_(&samples), position_(position), normal_(normal) {}

  /// Whether the sample is of any visit.
  bool any(Index sample) const { return samples_->disc_holds(sample, position_, normal_); }

  /// The visit of a sample that is of one, and by which sample the one before in its run was told.
  struct Found {
    Visit visit;
    Index begin_told_by = no_index;
  };

  /// `floor`: 0, or where an earlier visit begins; of no meaning for closed strokes.
  Found find(Index sample, Index floor) const;

  /// The visit that begins with this sample, and has at most so many.
  Visit from(Index begin, Index most = no_index) const;

 private:
  Index run_begin(Index sample, Index floor) const;
  Index farthest() const;
  float distance(Index sample) const { return samples_->chord(sample, position_); }

  const StrokeSamples* samples_;
  Vec3f position_, normal_;
};

}  // namespace burin
