// Groups a recorder's events into strokes.
#include <burin/stroke/files/pen_events.h>

namespace burin {

void ContactStrokes::take(const PenEvent& event) {
  if (!event.contact) {
    ++lifted_;
    open_.erase(event.pointer);
    return;
  }
  const auto [at, begins] = open_.try_emplace(event.pointer, strokes_.size());
  if (begins) strokes_.emplace_back();
  strokes_[at->second].push_back(event.sample);
}

}  // namespace burin
