// Groups a recorder's events into strokes.
#include <burin/stroke/files/pen_events.h>

namespace burin {

void set_buttons(PenEvent& event, double buttons) {
  constexpr unsigned barrel = 2, eraser = 32;
  constexpr double most = 0xffff;
  const unsigned held = buttons >= 0 && buttons <= most ? static_cast<unsigned>(buttons) : 0;
  event.contact = buttons != 0;
  event.sample.barrel = (held & barrel) != 0;
  event.eraser = (held & eraser) != 0;
}

void ContactStrokes::take(const PenEvent& event) {
  if (!event.contact) {
    ++lifted_;
    open_.erase(event.pointer);
    return;
  }
  const auto [at, begins] = open_.try_emplace(event.pointer, strokes_.size());
  if (begins || strokes_[at->second].eraser != event.eraser) {
    at->second = strokes_.size();
    strokes_.push_back({{}, event.eraser, event.pointer});
  }
  strokes_[at->second].samples.push_back(event.sample);
}

}  // namespace burin
