#pragma once
#include <burin/host/session.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/recording.h>

#include <optional>
#include <vector>

#include "options/view.h"
#include "pictures/checkerboard.h"

namespace burin {

/// Where strokes went and how far they reached: what a camera must know to look at them.
class StrokeExtent {
 public:
  /// Takes note of the session's last stroke.
  void piece_ended(const Session& session);

  const std::vector<SurfaceCurve>& curves() const { return curves_; }
  double widest() const { return widest_; }  ///< largest |d| of all charts, object units

 private:
  std::vector<SurfaceCurve> curves_;
  double widest_ = 0;
};

/// Remembers what strokes drew, for pictures of it.
class StrokeWitness {
 public:
  /// Takes note of the session's last stroke.
  void piece_ended(const Session& session);

  const StrokeExtent& extent() const { return extent_; }

  /// Linear RGB; clay everywhere when nothing was drawn.
  Vec3f colour(const SurfacePoint& point) const;

 private:
  StrokeExtent extent_;
  std::optional<Checkerboard> checkerboard_;
};

struct ReplayPictures {
  Picture before, after;
  Picture chart;  ///< the strokes' (t, d) and curves on the surface before
};

/// How to look at what was drawn on a surface: as the first recording on a screen did unless the options name
/// a direction, else at the strokes from above.
Camera replay_view(const Surface& surface, const StrokeExtent& extent,
                   const std::vector<Recording>& recordings, const ViewOptions& options);

/// Draws the session's surface without its strokes, which are undone for it, and their charts; not the
/// result.
ReplayPictures draw_replay(Session& session, const StrokeWitness& witness, const Camera& camera,
                           const Progress& progress);

/// A picture of plain clay.
Picture draw_mesh(TriangleMesh mesh, const Camera& camera, const Progress& progress);

}  // namespace burin
