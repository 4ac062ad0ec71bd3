#pragma once
#include <burin/host/session.h>
#include <burin/stamp/picture.h>

#include <optional>
#include <vector>

#include "checkerboard.h"
#include "view.h"

namespace burin {

/// Remembers what strokes drew, for pictures of it.
class StrokeWitness {
 public:
  /// Takes note of the session's last stroke.
  void piece_ended(const Session& session);

  const std::vector<SurfaceCurve>& curves() const { return curves_; }
  double widest() const { return widest_; }  ///< largest |d| of all charts, object units

  /// Linear RGB; clay everywhere when nothing was drawn.
  Vec3f colour(const SurfacePoint& point) const;

 private:
  std::vector<SurfaceCurve> curves_;
  std::optional<Checkerboard> checkerboard_;
  double widest_ = 0;
};

struct ReplayPictures {
  Picture before, after;
  Picture chart;  ///< the strokes' (t, d) and curves on the surface before
};

/// How to look at what a session drew: as the recording did if it has a camera and the options name no
/// direction, else at the strokes from above.
Camera replay_view(const Session& session, const StrokeWitness& witness,
                   const std::optional<Camera>& recorded, const ViewOptions& options);

/// Draws the surface with and without the strokes of the session, which are undone for it.
ReplayPictures draw_replay(Session& session, const StrokeWitness& witness, const Camera& camera,
                           const Progress& progress);

}  // namespace burin
