// Groups a recorder's events into strokes.
#include <burin/stroke/files/pen_events.h>

#include <map>

namespace burin {

std::vector<RecordedStroke> contact_strokes(const PenEvents& recorded, std::size_t& lifted) {
  std::vector<RecordedStroke> strokes;
  std::map<double, std::size_t> open;  // the stroke of each pointer that is down
  lifted = 0;
  for (const PenEvent& event : recorded.events) {
    if (!event.contact) {
      ++lifted;
      open.erase(event.pointer);
      continue;
    }
    const auto [at, begins] = open.try_emplace(event.pointer, strokes.size());
    if (begins) strokes.emplace_back().fields = recorded.fields;
    strokes[at->second].samples.push_back(event.sample);
  }
  return strokes;
}

}  // namespace burin
