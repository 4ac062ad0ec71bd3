#pragma once
#include <burin/base/vector.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Where vertices stood before a stroke.
struct UndoStep {
  std::vector<Index> vertices;
  std::vector<Vec3f> positions;  ///< [i] of vertices[i]
};

/// The finished strokes of a session, newest last: 16 bytes for each vertex that a stroke moved. Normals are
/// a function of positions and are not kept.
class UndoJournal {
 public:
  /// Notes where these vertices stand. A stroke that moved nothing is a step too.
  void record(std::span<const Index> vertices, std::span<const Vec3f> positions_of_surface);

  /// Takes the newest step out; nothing when there is none.
  std::optional<UndoStep> take();

 private:
  std::vector<UndoStep> steps_;
};

}  // namespace burin
