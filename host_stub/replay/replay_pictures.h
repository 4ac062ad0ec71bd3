#pragma once
#include <burin/base/vector.h>
#include <burin/host/session.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/recording.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "options/view.h"
#include "pictures/checkerboard.h"

namespace burin {

/// The curves of strokes and their greatest width, by which a camera is aimed.
class StrokeExtent {
 public:
  /// Records the session's last piece.
  void piece_ended(const Session& session);

  const std::vector<SurfaceCurve>& curves() const { return curves_; }
  double widest() const { return widest_; }  ///< greatest |d| of all charts, object units

 private:
  std::vector<SurfaceCurve> curves_;
  double widest_ = 0;
};

/// Records strokes for pictures of them.
class StrokeRecorder {
 public:
  /// Records the session's last piece.
  void piece_ended(const Session& session);

  const StrokeExtent& extent() const { return extent_; }

  /// The generation of the surface (Session::generation()) on which the charts run that are shown: the last.
  std::uint64_t generation() const { return generation_; }

  /// The colour at a point of that surface, linear RGB; clay if nothing was drawn.
  Vec3f colour(const SurfacePoint& point) const;

 private:
  StrokeExtent extent_;
  std::optional<Checkerboard> checkerboard_;
  std::uint64_t generation_ = 0;
};

struct ReplayPictures {
  Picture before, after;
  /// Coordinates (t, d) and curves of the strokes on the surface before; where strokes refined it, on that
  /// after them, with the charts since then.
  Picture chart;
};

/// The camera for pictures of a replay: that of the first recording in screen space, unless the options give
/// a direction; else one that looks at the strokes from above.
Camera replay_view(const Surface& surface, const StrokeExtent& extent,
                   const std::vector<Recording>& recordings, const ViewOptions& options);

/// Undoes the session's strokes and draws the surface without them, plain and with their charts. The picture
/// of the result is left empty.
ReplayPictures draw_replay(Session& session, const StrokeRecorder& recorder, const Camera& camera,
                           const Progress& progress);

}  // namespace burin
