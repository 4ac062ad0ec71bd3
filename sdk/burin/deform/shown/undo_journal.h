#pragma once
#include <burin/base/vector.h>
#include <burin/deform/shown/shown_paint.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// What a stroke made beside the surface.
enum class MadePart { none, solid, mesh };

/// The positions and paint of the vertices that a stroke changed, before it; or, of a stroke that was undone,
/// after it.
struct UndoStep {
  std::vector<Index> vertices;
  std::vector<Vec3f> positions;  ///< [i] of vertices[i]
  PaintStep paint;
  std::vector<Index> noted;  ///< vertices of which the host noted a number, beside what they are
  std::vector<float> notes;  ///< [i] of noted[i]
  MadePart made = MadePart::none;
  std::optional<Surface> surface;        ///< instead of vertices and their paint: what the stroke replaced
  Paint surface_paint;                   ///< of that
  bool refined = false, merged = false;  ///< what replaced it
};

/// The undo steps of the finished strokes of a session, newest last, or the redo steps of those that were
/// undone. A step takes 16 bytes per vertex that the stroke moved, and up to 24 per vertex that it painted.
/// Normals follow from positions and are not stored.
class UndoJournal {
 public:
  /// Stores the current positions of these vertices with what else a step has, such as the paint before the
  /// stroke. A stroke that changed nothing is a step too.
  void record(std::span<const Index> vertices, std::span<const Vec3f> positions_of_surface,
              UndoStep step = {});

  void record(UndoStep step);

  /// Removes and returns the newest step; nothing if there is none.
  std::optional<UndoStep> take();

  /// The newest step; null if there is none.
  const UndoStep* newest() const { return steps_.empty() ? nullptr : &steps_.back(); }

  /// Removes and returns the oldest step. There must be one.
  UndoStep drop_oldest();

  /// Removes all steps.
  void clear();

  std::size_t size() const { return steps_.size(); }
  std::size_t bytes() const { return bytes_; }  ///< of all steps

 private:
  std::deque<UndoStep> steps_;
  std::size_t bytes_ = 0;
};

}  // namespace burin
