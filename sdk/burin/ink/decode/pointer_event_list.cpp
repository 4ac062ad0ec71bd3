// Reads lists of PointerEvents one event after the other. Positions are those of the window unless the events
// have x and y of their own.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/ink/decode/pointer_event_list.h>
#include <burin/ink/decode/pointer_points.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/stroke/files/pen_events.h>

#include <array>
#include <map>
#include <string>
#include <utility>

namespace burin {
namespace {

using Names = std::array<const char*, 4>;
constexpr Names x_names = {"x", "clientX", "pageX", "offsetX"},
                y_names = {"y", "clientY", "pageY", "offsetY"};

double position(const JsonValue& event, const Names& names) {
  for (const char* name : names)
    if (const auto found = event.find(name)) return found->number();
  return event.member(names[0]).number();
}

/// Collects events, and what all of them have.
class EventList {
 public:
  void take(const JsonValue& json);
  PenFile finish();

 private:
  bool touches(const JsonValue& json, const PenEvent& event);

  PenEvents all_;
  std::array<bool, pointer_channels.size()> whole_{};
  std::map<double, bool> down_;  ///< by pointer
  std::string_view tool_;
  bool reported_ = true;  ///< a pressure is what a device reports
};

void EventList::take(const JsonValue& json) {
  PenEvent event;
  event.sample.position = {position(json, x_names), position(json, y_names), 0};
  const bool first = all_.events.empty();
  for (std::size_t i = 0; i < pointer_channels.size(); ++i) {
    const auto value = channel_of(json, pointer_channels[i]);
    if (value) pointer_channels[i].set(event.sample, value->number());
    whole_[i] = (first || whole_[i]) && value;
  }
  if (const auto pointer = json.find("pointerId")) event.pointer = pointer->number();
  const auto type = json.find("pointerType");
  if (type && type->is_text()) tool_ = tool_of_pointer_type(type->text());
  if (first) reported_ = json.find(std::string(reported_pressure)).has_value();
  event.contact = touches(json, event);
  all_.events.push_back(event);
}

bool EventList::touches(const JsonValue& json, const PenEvent& event) {
  if (const auto buttons = json.find("buttons")) return buttons->number() != 0;
  const auto type = json.find("type");
  if (!type || !type->is_text()) return event.sample.pen.pressure > 0;
  bool& down = down_[event.pointer];
  const std::string name = type->text();
  if (name.ends_with("down") || name.ends_with("start")) down = true;
  if (!name.ends_with("down") && !name.ends_with("start") && !name.ends_with("move")) down = false;
  return down;
}

PenFile EventList::finish() {
  PenFile content;
  content.unit = "px";
  for (std::size_t i = 0; i < pointer_channels.size(); ++i)
    if (whole_[i]) all_.fields.*pointer_channels[i].field = true;
  for (RecordedStroke& stroke : contact_strokes(all_, content.hovering)) {
    PenStroke& made = content.strokes.emplace_back();
    made.fields = stroke.fields;
    made.tool = tool_;
    made.made_pressure = stroke.fields.pressure && !reported_;
    made.samples = std::move(stroke.samples);
    keep_channels(made, whole_);
  }
  return content;
}

}  // namespace

bool begins_as_event_list(std::string_view text) {
  if (!take_character(text, '[') || !take_character(text, '{')) return false;
  text = text.substr(0, text.find('}'));
  return text.find('[') == text.npos &&
         (text.find("\"x\"") != text.npos || text.find("\"clientX\"") != text.npos);
}

PenFile read_event_list(const PenFileText& file) {
  const auto by_events = pen_file_by_parts([&](PenFile& content) {
    EventList events;
    const bool read = for_each_json_part(file.text, [&](std::string_view, std::string_view event) {
      events.take(pen_json_part(file, event));
      return true;
    });
    content = events.finish();
    return read;
  });
  if (by_events) return *by_events;
  EventList events;
  for (const JsonValue& event : pen_json(file).items()) events.take(event);
  return events.finish();
}

}  // namespace burin
