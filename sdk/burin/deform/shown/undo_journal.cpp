// Stores what strokes changed, in O(changed vertices).
#include <burin/deform/shown/undo_journal.h>

#include <utility>

namespace burin {

void UndoJournal::record(std::span<const Index> vertices, std::span<const Vec3f> positions_of_surface,
                         PaintStep paint, MadePart made) {
  UndoStep step;
  step.vertices.assign(vertices.begin(), vertices.end());
  step.positions.reserve(vertices.size());
  for (const Index vertex : vertices) step.positions.push_back(positions_of_surface[vertex]);
  step.paint = std::move(paint);
  step.made = made;
  record(std::move(step));
}

void UndoJournal::record(Surface surface, Paint paint) {
  UndoStep step;
  step.surface = std::move(surface);
  step.surface_paint = std::move(paint);
  record(std::move(step));
}

void UndoJournal::record(UndoStep step) { steps_.push_back(std::move(step)); }

std::optional<UndoStep> UndoJournal::take() {
  if (steps_.empty()) return std::nullopt;
  UndoStep step = std::move(steps_.back());
  steps_.pop_back();
  return step;
}

}  // namespace burin
