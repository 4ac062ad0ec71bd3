#pragma once
#include <burin/base/vector.h>
#include <burin/deform/shown/shown_paint.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Where vertices stood before a stroke, and what was painted there.
struct UndoStep {
  std::vector<Index> vertices;
  std::vector<Vec3f> positions;  ///< [i] of vertices[i]
  PaintStep paint;
};

/// The finished strokes of a session, newest last: 16 bytes for each vertex that a stroke moved, and up to 24
/// for each that it painted. Normals are a function of positions and are not kept.
class UndoJournal {
 public:
  /// Notes where these vertices stand, and the paint before. A stroke that changed nothing is a step too.
  void record(std::span<const Index> vertices, std::span<const Vec3f> positions_of_surface,
              PaintStep paint = {});

  /// Takes the newest step out; nothing when there is none.
  std::optional<UndoStep> take();

 private:
  std::vector<UndoStep> steps_;
};

}  // namespace burin
