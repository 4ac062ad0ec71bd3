// Reads strokes of web programs from JSON: a list of strokes, or an object that has one as "strokes" or
// "pointers". A stroke has its points as a list of objects, {"pointers": [{"x", "y", "t", "p"}]} or the list
// alone, or as lists of numbers, {"x": [], "y": [], "t": [], "p": []}. Positions are CSS pixels, times
// milliseconds, tilts and twist degrees, as PointerEvent has them.
//
// "p" is what programs make of the speed and call pressure, "pressure" what a device reports.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// The member of the first of these names that a value has; null names are none.
template <std::size_t count>
std::optional<JsonValue> any_of(const JsonValue& value, const std::array<const char*, count>& names) {
  for (const char* name : names) {
    if (name == nullptr) continue;
    if (auto found = value.find(name)) return found;
  }
  return std::nullopt;
}

/// Values of one channel: of the points, or of the stroke as a list.
struct Channel {
  std::array<const char*, 4> names;
  void (*set)(Sample& sample, double value);
  bool PenFields::*field;
};

const std::array channels = {
    Channel{{"t", "time", "timestamp", "timeStamp"},
            [](Sample& s, double v) { s.time = v / 1000; },
            &PenFields::time},
    Channel{{"pressure", "p", "force", "f"},
            [](Sample& s, double v) { s.pen.pressure = static_cast<float>(v); },
            &PenFields::pressure},
    Channel{{"tiltX"},
            [](Sample& s, double v) { s.pen.tilt_x = static_cast<float>(v * degree); },
            &PenFields::tilt},
    Channel{{"tiltY"},
            [](Sample& s, double v) { s.pen.tilt_y = static_cast<float>(v * degree); },
            &PenFields::tilt},
    Channel{{"twist"},
            [](Sample& s, double v) { s.pen.twist = static_cast<float>(v * degree); },
            &PenFields::twist}};

void read_points(const JsonValue& points, PenStroke& stroke) {
  const std::vector<JsonValue> items = points.items();
  // A channel that some points lack is none.
  std::array<bool, channels.size()> whole{};
  for (std::size_t i = 0; i < channels.size(); ++i)
    whole[i] = std::ranges::all_of(
        items, [&](const JsonValue& point) { return any_of(point, channels[i].names).has_value(); });
  for (const JsonValue& point : items) {
    Sample& sample = stroke.samples.emplace_back();
    sample.position = {point.member("x").number(), point.member("y").number(), 0};
    for (std::size_t i = 0; i < channels.size(); ++i)
      if (whole[i]) channels[i].set(sample, any_of(point, channels[i].names)->number());
  }
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (whole[i] && !items.empty()) stroke.fields.*channels[i].field = true;
  if (!items.empty()) stroke.made_pressure = stroke.fields.pressure && !items[0].find("pressure");
}

void read_lists(const JsonValue& lists, PenStroke& stroke) {
  const std::vector<double> x = lists.member("x").numbers(), y = lists.member("y").numbers();
  if (x.size() != y.size()) lists.reject("x and y differ in their count");
  for (std::size_t i = 0; i < x.size(); ++i) stroke.samples.emplace_back().position = {x[i], y[i], 0};
  for (const Channel& channel : channels) {
    const auto found = any_of(lists, channel.names);
    if (!found || !found->is_array() || found->size() == 0) continue;
    const std::vector<double> values = found->numbers();
    if (values.size() != x.size()) found->reject("has another count than x");
    for (std::size_t i = 0; i < x.size(); ++i) channel.set(stroke.samples[i], values[i]);
    stroke.fields.*channel.field = true;
  }
  stroke.made_pressure = stroke.fields.pressure && !lists.find("pressure");
}

std::optional<JsonValue> points_of(const JsonValue& stroke) {
  if (stroke.is_array()) {
    const bool of_points = stroke.size() > 0 && stroke.items().front().is_object();
    return of_points ? std::optional(stroke) : std::nullopt;
  }
  return stroke.is_object() ? any_of(stroke, std::array{"pointers", "points"}) : std::nullopt;
}

/// Takes the strokes of a list; shapes without points may stand between.
void read_strokes_of(const JsonValue& list, PenFile& content) {
  for (const JsonValue& one : list.items()) {
    PenStroke stroke;
    if (const auto points = points_of(one))
      read_points(*points, stroke);
    else if (one.is_object() && one.find("x") && one.member("x").is_array())
      read_lists(one, stroke);
    if (!stroke.samples.empty()) content.strokes.push_back(std::move(stroke));
  }
}

/// What a text has before its first object or list within the outermost list or object.
bool has_key_early(std::string_view text, std::string_view key) {
  constexpr std::size_t early = 4096;
  return text.substr(0, early).find(key) != text.npos;
}

/// Whether a text begins as a list of lists of objects with an x.
bool begins_with_lists_of_points(std::string_view text) {
  for (const char next : {'[', '[', '{'}) {
    skip_blanks(text);
    if (!text.starts_with(next)) return false;
    text.remove_prefix(1);
  }
  return has_key_early(text, "\"x\"");
}

}  // namespace

bool is_pointers(std::string_view text) {
  skip_blanks(text);
  if (begins_with_lists_of_points(text)) return true;
  if (text.starts_with('[')) return has_key_early(text, "\"pointers\"") || has_key_early(text, "\"points\"");
  return text.starts_with('{') && (has_key_early(text, "\"strokes\"") || has_key_early(text, "\"pointers\""));
}

PenFile read_pointers(const PenFileText& file) {
  const JsonValue root = pen_json(file);
  PenFile content;
  content.unit = "px";
  if (root.is_array()) {
    read_strokes_of(root, content);
  } else if (const auto strokes = root.find("strokes")) {
    read_strokes_of(*strokes, content);
  } else {
    PenStroke stroke;
    read_points(root.member("pointers"), stroke);
    content.strokes.push_back(std::move(stroke));
  }
  return content;
}

}  // namespace burin
