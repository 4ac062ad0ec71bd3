#include <burin/host/session/stroke_products.h>

#include <optional>

namespace burin {

MadePart StrokeProducts::add(OpenStroke& stroke) {
  if (stroke.bent()) {
    bent_meshes.there.push_back(std::move(*stroke.bent()));
    return MadePart::mesh;
  }
  std::optional<StrokeSolid>& solid = stroke.solid();
  if (!solid || solid->empty()) return MadePart::none;
  parts.there.push_back(std::move(*solid));
  return MadePart::solid;
}

void StrokeProducts::take(const UndoStep& step, Turn turn) {
  if (step.refined) refinements.take(turn);
  if (step.merged) merges.take(turn);
  if (step.made == MadePart::solid) parts.take(turn);
  if (step.made == MadePart::mesh) bent_meshes.take(turn);
}

void StrokeProducts::end_redoing() {
  refinements.undone.clear();
  parts.undone.clear();
  merges.undone.clear();
  bent_meshes.undone.clear();
}

}  // namespace burin
