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

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Names = std::array<std::string_view, 4>;
constexpr Names x_names = {"x", "clientX", "pageX", "offsetX"},
                y_names = {"y", "clientY", "pageY", "offsetY"};

/// A number that may have several names, of which the first in their order counts.
struct Named {
  double value = 0;
  std::size_t rank = 4;  ///< of the name that it has; 4: it has none

  bool has() const { return rank < 4; }
};

/// What an event says.
struct ListedEvent {
  Named x, y;
  std::array<Named, pointer_channels.size()> channels;
  std::optional<double> pointer, buttons, altitude, azimuth;
  std::optional<std::string> type, pointer_type;
};

Named named_in(const JsonValue& json, const Names& names) {
  for (std::size_t rank = 0; rank < names.size(); ++rank)
    if (const auto found = names[rank].empty() ? std::nullopt : told(json, names[rank]))
      return {found->number(), rank};
  return {};
}

/// Gives an event the tilts that it tells by other angles only.
void tilt_by_angles(ListedEvent& event) {
  Named &x = event.channels[tilt_x_channel], &y = event.channels[tilt_y_channel];
  if (x.has() || y.has() || !event.altitude || !event.azimuth) return;
  const auto tilts = tilts_of(*event.altitude, *event.azimuth);
  x = {tilts[0], 0};
  y = {tilts[1], 0};
}

ListedEvent event_of(const JsonValue& json) {
  ListedEvent event;
  event.x = named_in(json, x_names);
  event.y = named_in(json, y_names);
  if (!event.x.has()) json.member("x");
  if (!event.y.has()) json.member("y");
  for (std::size_t i = 0; i < pointer_channels.size(); ++i)
    event.channels[i] = named_in(json, pointer_channels[i].names);
  const auto number = [&](std::string_view name, std::optional<double>& value) {
    if (const auto found = told(json, name)) value = found->number();
  };
  number("pointerId", event.pointer);
  number("buttons", event.buttons);
  number(altitude_name, event.altitude);
  number(azimuth_name, event.azimuth);
  tilt_by_angles(event);
  const auto text = [&](const char* name) {
    const auto found = json.find(name);
    return found && found->is_text() ? std::optional(found->text()) : std::nullopt;
  };
  event.type = text("type");
  event.pointer_type = text("pointerType");
  return event;
}

/// Whether a member has the events that were put together in one, as getCoalescedEvents() gives them.
bool is_of_coalesced(std::string_view name) { return name.find("oalesced") != name.npos; }

/// Gives an event what it does not say, and the event does into which it was put.
void take_missing(const ListedEvent& whole, ListedEvent& event) {
  for (std::size_t i = 0; i < event.channels.size(); ++i)
    if (!event.channels[i].has()) event.channels[i] = whole.channels[i];
  if (!event.pointer) event.pointer = whole.pointer;
  if (!event.buttons) event.buttons = whole.buttons;
  if (!event.type) event.type = whole.type;
  if (!event.pointer_type) event.pointer_type = whole.pointer_type;
}

/// The events that were put together in one, or else this one.
std::vector<ListedEvent> events_of(const JsonValue& json) {
  const ListedEvent whole = event_of(json);
  std::vector<ListedEvent> events;
  for (const auto& [name, member] : json.members()) {
    if (!is_of_coalesced(name) || !member.is_array() || !events.empty()) continue;
    for (const JsonValue& one : member.items()) take_missing(whole, events.emplace_back(event_of(one)));
  }
  if (events.empty()) events.push_back(whole);
  return events;
}

std::optional<double> number_of(std::string_view part) {
  double value = 0;
  return take_number(part, value) && part.empty() ? std::optional(value) : std::nullopt;
}

/// A text without escapes.
std::optional<std::string> text_of(std::string_view part) {
  const bool plain = part.size() >= 2 && part.front() == '"' && part.find('\\') == part.npos;
  return plain ? std::optional(std::string(part.substr(1, part.size() - 2))) : std::nullopt;
}

/// Sets a number if the name is one of these. Returns false if it is, and the part no number.
bool take_named(std::string_view name, std::string_view part, const Names& names, Named& named) {
  const auto rank = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  if (rank >= named.rank || name.empty()) return true;
  const auto value = number_of(part);
  if (value) named = {*value, rank};
  return value.has_value();
}

/// Removes the event at the front of a text, read without a tree of JSON values; nothing if events_of() may
/// find a fault or several.
std::optional<ListedEvent> plain_event(TextWindow& json) {
  ListedEvent event;
  const bool whole = for_each_json_part(json, [&](std::string_view name, TextWindow& of_part) {
    const std::string_view part = take_json_value(of_part);
    if (is_of_coalesced(name)) return part == "[]";
    if (name == "pointerId") return (event.pointer = number_of(part)).has_value();
    if (name == "buttons") return (event.buttons = number_of(part)).has_value();
    if (name == altitude_name) return (event.altitude = number_of(part)).has_value();
    if (name == azimuth_name) return (event.azimuth = number_of(part)).has_value();
    if (name == "type") return (event.type = text_of(part)).has_value();
    if (name == "pointerType") return (event.pointer_type = text_of(part)).has_value();
    bool good = take_named(name, part, x_names, event.x) && take_named(name, part, y_names, event.y);
    for (std::size_t i = 0; i < pointer_channels.size(); ++i)
      good = good && take_named(name, part, pointer_channels[i].names, event.channels[i]);
    return good && name.find('\\') == name.npos;
  });
  tilt_by_angles(event);
  return whole && event.x.has() && event.y.has() ? std::optional(std::move(event)) : std::nullopt;
}

/// Collects events, and what all of them have.
class EventList {
 public:
  void take(const ListedEvent& listed);
  PenFile finish();

 private:
  bool goes_down(const ListedEvent& listed, const PenEvent& event);
  void set_contact(const ListedEvent& listed, PenEvent& event);
  std::string_view tool_of(double pointer) const;

  ContactStrokes strokes_;
  std::array<bool, pointer_channels.size()> whole_{};
  std::map<double, bool> down_;               ///< by pointer
  std::map<double, std::string_view> tools_;  ///< by pointer
  bool first_ = true;
  bool has_buttons_ = true;  ///< all events tell them
  bool reported_ = true;     ///< a pressure is what a device reports
};

void EventList::take(const ListedEvent& listed) {
  PenEvent event;
  event.sample.position = {listed.x.value, listed.y.value, 0};
  for (std::size_t i = 0; i < pointer_channels.size(); ++i) {
    const Named& channel = listed.channels[i];
    if (channel.has()) pointer_channels[i].set(event.sample, channel.value);
    whole_[i] = (first_ || whole_[i]) && channel.has();
  }
  event.pointer = listed.pointer.value_or(event.pointer);
  if (listed.pointer_type) tools_[event.pointer] = tool_of_pointer_type(*listed.pointer_type);
  if (first_) reported_ = listed.channels[pressure_channel].rank == 0;
  first_ = false;
  set_contact(listed, event);
  strokes_.take(event);
}

void EventList::set_contact(const ListedEvent& listed, PenEvent& event) {
  has_buttons_ &= listed.buttons.has_value();
  if (listed.buttons) return set_buttons(event, *listed.buttons);
  event.contact = listed.type ? goes_down(listed, event) : event.sample.pen.pressure > 0;
}

bool EventList::goes_down(const ListedEvent& listed, const PenEvent& event) {
  bool& down = down_[event.pointer];
  const std::string& name = *listed.type;
  if (name.ends_with("down") || name.ends_with("start")) down = true;
  if (!name.ends_with("down") && !name.ends_with("start") && !name.ends_with("move")) down = false;
  return down;
}

std::string_view EventList::tool_of(double pointer) const {
  const auto found = tools_.find(pointer);
  return found == tools_.end() ? std::string_view() : found->second;
}

PenFile EventList::finish() {
  PenFile content;
  content.unit = "px";
  content.hovering = strokes_.lifted();
  PenFields fields;
  for (std::size_t i = 0; i < pointer_channels.size(); ++i)
    if (whole_[i]) fields.*pointer_channels[i].field = true;
  for (ContactStroke& stroke : strokes_.take_strokes()) {
    PenStroke& made = content.strokes.emplace_back();
    made.fields = fields;
    const std::string_view tool = tool_of(stroke.pointer);
    made.fields.barrel = has_buttons_ && (tool.empty() || tool == "pen");
    made.drawn_by = {std::string(tool), stroke.eraser};
    made.made_pressure = fields.pressure && !reported_;
    made.samples = std::move(stroke.samples);
    if (!made.fields.barrel)
      for (Sample& sample : made.samples) sample.barrel = false;  // the right button of a mouse
    keep_channels(made, whole_);
  }
  return content;
}

PenFile read_event_lines(const PenFileText& file) {
  EventList events;
  const auto take_plain = [&](std::string_view text) {
    TextWindow window(text);
    const auto plain = plain_event(window);
    if (!plain || window.skip_blanks()) return false;
    events.take(*plain);
    return true;
  };
  for_each_json_value(file, take_plain, [&](const JsonValue& value) {
    for (const ListedEvent& event : events_of(value)) events.take(event);
  });
  return events.finish();
}

/// The text from the list that an object has as "events" on; empty if it has none early.
std::string_view at_events(std::string_view text) {
  constexpr std::size_t early = 4096;
  constexpr std::string_view name = "\"events\"";
  const std::size_t at = text.substr(0, early).find(name);
  if (!take_character(text, '{') || at == text.npos) return {};
  text = text.substr(std::min(at - 1 + name.size(), text.size()));
  if (!take_character(text, ':')) return {};
  skip_blanks(text);
  return text;
}

}  // namespace

bool begins_as_event_list(std::string_view text) {
  TextWindow window(text);
  if (!take_character(text, '[') && !begins_as_json_lines(window)) return false;
  if (!take_character(text, '{')) return false;
  const std::size_t end = text.find_first_of("}[");
  const bool flat = end != text.npos && text[end] == '}';
  text = text.substr(0, end);
  return (flat || is_of_coalesced(text)) &&
         (text.find("\"x\"") != text.npos || text.find("\"clientX\"") != text.npos);
}

bool has_event_list(std::string_view text) {
  skip_blanks(text);
  const std::string_view list = at_events(text);
  return list.starts_with('[') && begins_as_event_list(list);
}

PenFile read_event_list(const PenFileText& file) {
  const bool within = !begins_as_event_list(file.text);
  if (!within && file.text.find('{') < file.text.find('[')) return read_event_lines(file);
  auto by_events = pen_file_by_parts(file, [&](TextWindow& text, PenFile& content) {
    EventList events;
    if (within) return false;
    const bool read = for_each_json_part(text, [&](std::string_view, TextWindow& json) {
      json.skip_blanks();
      const std::uintmax_t place = json.place();
      if (const auto event = plain_event(json)) {
        events.take(*event);
        return true;
      }
      json.go_to(place);
      for (const ListedEvent& event : events_of(pen_json_part(file, take_json_value(json))))
        events.take(event);
      return true;
    });
    content = events.finish();
    return read;
  });
  if (by_events) return std::move(*by_events);
  EventList events;
  const JsonValue root = pen_json(file), list = within ? root.member("events") : root;
  for (const JsonValue& one : list.items())
    for (const ListedEvent& event : events_of(one)) events.take(event);
  return events.finish();
}

}  // namespace burin
