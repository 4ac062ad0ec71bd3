// Reads strokes of web programs from JSON: a list of strokes, or an object that has one as "strokes",
// "events" or "pointers", or in groups as "strokeGroups". A stroke has its points as a list of objects,
// {"pointers": [{"x", "y", "t", "p"}]} or the list alone, or as lists of numbers, {"x": [], "y": [], "t": [],
// "p": []}; a point may be a list [x, y, pressure, time], too. Each line may have a stroke instead, or a
// drawing of Quick, Draw! [github.com/googlecreativelab/quickdraw-dataset], {"drawing": [[[x...], [y...],
// [t...]]]}. Positions are CSS pixels, times milliseconds, tilts and twist degrees, as PointerEvent has them.
// Groups of strokes may stand in a list, with their strokes as "children" or "strokes". What says of itself
// that it is a shape, text or line between shapes has no strokes, even if it has points.
//
// "p" is what programs make of the speed and call pressure, "pressure" what a device reports.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/ink/decode/pointer_points.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/no_pressure.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

bool has_reported_pressure(const JsonValue& value) {
  return value.find(std::string(reported_pressure)).has_value();
}

/// Gives the points of a stroke without tilts those that all of them tell by other angles.
void tilt_by_angles(const std::vector<JsonValue>& points, PenStroke& stroke) {
  const auto tells = [](const JsonValue& point) {
    return told(point, altitude_name) && told(point, azimuth_name);
  };
  if (stroke.fields.tilt || !std::ranges::all_of(points, tells)) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto tilts =
        tilts_of(told(points[i], altitude_name)->number(), told(points[i], azimuth_name)->number());
    pointer_channels[tilt_x_channel].set(stroke.samples[i], tilts[0]);
    pointer_channels[tilt_y_channel].set(stroke.samples[i], tilts[1]);
  }
  stroke.fields.tilt = true;
}

/// Reads points that are lists of x, y and, as perfect-freehand has them, a pressure and a time in
/// milliseconds. A third number that is no pressure of 0..1 may be anything, and is not used.
void read_number_points(const std::vector<JsonValue>& points, PenStroke& stroke) {
  PenFields& fields = stroke.fields;
  fields.time = fields.pressure = true;
  for (const JsonValue& point : points) {
    constexpr std::size_t most_numbers = 4;
    const std::vector<double> numbers = point.numbers();
    if (numbers.size() < 2 || numbers.size() > most_numbers) point.reject_type("a list of x and y");
    Sample& sample = stroke.samples.emplace_back();
    sample.position = {numbers[0], numbers[1], 0};
    fields.pressure &= numbers.size() > 2 && numbers[2] >= 0 && numbers[2] <= 1;
    fields.time &= fields.pressure && numbers.size() > 3;
    if (fields.pressure) sample.pen.pressure = static_cast<float>(numbers[2]);
    if (fields.time) sample.time = numbers[3] / 1000;
  }
  keep_channels(stroke, {fields.time, fields.pressure, true, true, true});
}

bool is_point_of_numbers(const JsonValue& point) { return point.is_array() && point.size() >= 2; }

void read_points(const JsonValue& points, PenStroke& stroke) {
  const std::vector<JsonValue> items = points.items();
  if (!items.empty() && is_point_of_numbers(items.front())) return read_number_points(items, stroke);
  for (const JsonValue& point : items)
    stroke.samples.emplace_back().position = {point.member("x").number(), point.member("y").number(), 0};
  if (items.empty()) return;
  for (const PointerChannel& channel : pointer_channels) {
    // A channel that some points lack is none.
    if (!std::ranges::all_of(items,
                             [&](const JsonValue& point) { return channel_of(point, channel).has_value(); }))
      continue;
    stroke.fields.*channel.field = true;
    for (std::size_t i = 0; i < items.size(); ++i)
      channel.set(stroke.samples[i], channel_of(items[i], channel)->number());
  }
  tilt_by_angles(items, stroke);
  stroke.made_pressure = stroke.fields.pressure && !has_reported_pressure(items[0]);
}

void read_lists(const JsonValue& lists, PenStroke& stroke) {
  const std::vector<double> x = lists.member("x").numbers(), y = lists.member("y").numbers();
  if (x.size() != y.size()) lists.reject("x and y differ in their count");
  for (std::size_t i = 0; i < x.size(); ++i) stroke.samples.emplace_back().position = {x[i], y[i], 0};
  for (const PointerChannel& channel : pointer_channels) {
    const auto found = channel_of(lists, channel);
    if (!found || !found->is_array() || found->size() == 0) continue;
    const std::vector<double> values = found->numbers();
    if (values.size() != x.size()) found->reject("has another count than x");
    for (std::size_t i = 0; i < x.size(); ++i) channel.set(stroke.samples[i], values[i]);
    stroke.fields.*channel.field = true;
  }
  stroke.made_pressure = stroke.fields.pressure && !has_reported_pressure(lists);
}

std::optional<JsonValue> points_of(const JsonValue& stroke) {
  if (stroke.is_array()) {
    if (stroke.size() == 0) return std::nullopt;
    const JsonValue first = stroke.items().front();
    return first.is_object() || is_point_of_numbers(first) ? std::optional(stroke) : std::nullopt;
  }
  if (!stroke.is_object()) return std::nullopt;
  const auto pointers = stroke.find("pointers");
  return pointers ? pointers : stroke.find("points");
}

/// A stroke of any shape; one without samples for a shape that has none.
PenStroke stroke_of(const JsonValue& one) {
  PenStroke stroke;
  if (const auto points = points_of(one))
    read_points(*points, stroke);
  else if (one.is_object() && one.find("x") && one.member("x").is_array())
    read_lists(one, stroke);
  const auto type = one.is_object() ? one.find("pointerType") : std::nullopt;
  if (type && type->is_text()) stroke.drawn_by.tool = tool_of_pointer_type(type->text());
  return stroke;
}

/// Adds a stroke; shapes without points may stand between strokes.
void add(PenStroke stroke, PenFile& content) {
  if (!stroke.samples.empty()) content.strokes.push_back(std::move(stroke));
}

/// Notes once what is not used.
void leave_out(const std::string& name, PenFile& content) {
  if (std::ranges::find(content.not_used, name) == content.not_used.end()) content.not_used.push_back(name);
}

/// Adds what an element of a list has: a stroke, or those of a group. A shape has no strokes of its own.
void add_strokes_of(const JsonValue& one, PenFile& content) {
  const auto type = one.is_object() ? one.find("type") : std::nullopt;
  const bool shape = type && type->is_text() && is_shape_of_program(type->text());
  if (shape) leave_out(type->text(), content);
  PenStroke stroke = shape ? PenStroke() : stroke_of(one);
  const bool may_be_group = one.is_object() && stroke.samples.empty();
  add(std::move(stroke), content);
  for (const std::string_view name : groups_of_strokes) {
    const auto members = may_be_group ? told(one, name) : std::nullopt;
    if (!members || !members->is_array()) continue;
    for (const JsonValue& member : members->items()) add_strokes_of(member, content);
  }
}

void read_strokes_of(const JsonValue& list, PenFile& content) {
  for (const JsonValue& one : list.items()) add_strokes_of(one, content);
}

/// The list of strokes that an object has.
std::optional<JsonValue> list_of_strokes(const JsonValue& root) {
  const auto strokes = root.find("strokes");
  return strokes ? strokes : root.find("events");
}

/// Reads stroke by stroke. Returns false for what must be read as a whole.
bool read_by_strokes(const PenFileText& file, TextWindow& text, PenFile& content) {
  const auto take_stroke = [&](std::string_view, TextWindow& json) {
    const std::string_view part = take_json_value(json);
    if (auto stroke = plain_pointer_stroke(part))
      add(std::move(*stroke), content);
    else
      add_strokes_of(pen_json_part(file, part), content);
    return true;
  };
  const auto take_list_of_group = [&](std::string_view name, TextWindow& json) {
    return name == "strokes" ? for_each_json_part(json, take_stroke)
                             : nlohmann::json::accept(take_json_value(json));
  };
  const auto take_group = [&](std::string_view, TextWindow& json) {
    return for_each_json_part(json, take_list_of_group);
  };
  const auto take_member = [&](std::string_view name, TextWindow& json) {
    if (name == "strokeGroups") return for_each_json_part(json, take_group);
    return name == "strokes" || name == "events" ? for_each_json_part(json, take_stroke)
                                                 : nlohmann::json::accept(take_json_value(json));
  };
  text.skip_blanks();
  const bool read = text.text().starts_with('[') ? for_each_json_part(text, take_stroke)
                                                 : for_each_json_part(text, take_member);
  return read && !content.strokes.empty();
}

/// Reads a drawing, each stroke of which is its list of x, that of y and, unless it was simplified, that of
/// the times.
void read_drawing(const JsonValue& drawing, std::size_t page, PenFile& content) {
  for (const JsonValue& one : drawing.items()) {
    const std::vector<JsonValue> lists = one.items();
    if (lists.size() < 2) one.reject("no lists of x and y");
    PenStroke stroke;
    stroke.page = page;
    const std::vector<double> x = lists[0].numbers(), y = lists[1].numbers();
    const std::vector<double> times = lists.size() > 2 ? lists[2].numbers() : std::vector<double>();
    stroke.fields.time = !times.empty();
    if (x.size() != y.size() || (stroke.fields.time && times.size() != x.size()))
      one.reject("lists that differ in their count");
    constexpr double millisecond = 1e-3;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Sample& sample = stroke.samples.emplace_back();
      sample.position = {x[i], y[i], 0};
      if (stroke.fields.time) sample.time = millisecond * times[i];
    }
    add(std::move(stroke), content);
  }
}

std::optional<JsonValue> drawing_of(const JsonValue& line) {
  return line.is_object() ? line.find("drawing") : std::nullopt;
}

/// Whether a list is one of points, which are lists of numbers, rather than of strokes.
bool is_list_of_points(const JsonValue& root) {
  if (!root.is_array() || root.size() == 0) return false;
  const JsonValue first = root.items().front();
  return is_point_of_numbers(first) && !first.items().front().is_array() &&
         !first.items().front().is_object();
}

void read_whole(const JsonValue& root, PenFile& content) {
  if (is_list_of_points(root)) return read_points(root, content.strokes.emplace_back());
  const auto list = root.is_array() ? std::optional(root) : list_of_strokes(root);
  if (list)
    read_strokes_of(*list, content);
  else if (const auto groups = root.find("strokeGroups"))
    for (const JsonValue& group : groups->items()) read_strokes_of(group.member("strokes"), content);
  else if (const auto drawing = drawing_of(root))
    read_drawing(*drawing, 1, content);
  else
    read_points(root.member("pointers"), content.strokes.emplace_back());
}

/// Members of objects that have many strokes, and are mostly all of a file.
constexpr std::array<std::string_view, 3> lists_of_strokes = {"strokes", "events", "strokeGroups"};

bool has_list_of_strokes(const JsonValue& line) {
  return line.is_object() && std::ranges::any_of(lists_of_strokes, [&](std::string_view name) {
           return line.find(std::string(name)).has_value();
         });
}

/// Reads strokes, or drawings of a page each, that follow each other.
PenFile read_lines(const PenFileText& file) {
  PenFile content;
  std::size_t pages = 0;
  const auto take_plain = [&](std::string_view text) {
    auto plain = plain_pointer_stroke(text);
    if (!plain || plain->samples.empty()) return false;
    add(std::move(*plain), content);
    return true;
  };
  for_each_json_value(file, take_plain, [&](const JsonValue& value) {
    if (const auto drawing = drawing_of(value))
      read_drawing(*drawing, ++pages, content);
    else if (has_list_of_strokes(value) && stroke_of(value).samples.empty())
      read_whole(value, content);
    else
      add_strokes_of(value, content);
  });
  return content;
}

/// What a text has before its first object or list within the outermost list or object.
bool has_key_early(std::string_view text, std::string_view key) {
  constexpr std::size_t early = 4096;
  return text.substr(0, early).find(key) != text.npos;
}

/// Whether all samples of a file that have a pressure have this one.
bool has_only_pressure(const PenFile& content, float pressure) {
  return std::ranges::all_of(content.strokes, [&](const PenStroke& stroke) {
    return !stroke.fields.pressure || std::ranges::all_of(stroke.samples, [&](const Sample& sample) {
      return sample.pen.pressure == pressure;
    });
  });
}

/// Takes a pressure that is 0 at every sample for none: so do touches of devices that measure it not. One of
/// 0.5 throughout is what browsers tell of such devices.
void leave_out_dead_pressure(PenFile& content) {
  if (has_only_pressure(content, 0.5F))
    for (PenStroke& stroke : content.strokes) stroke.made_pressure = stroke.fields.pressure;
  if (!has_only_pressure(content, 0)) return;
  for (PenStroke& stroke : content.strokes) {
    if (!stroke.fields.pressure) continue;
    stroke.made_pressure = false;
    leave_out_pressure(stroke);
  }
}

/// Whether a text begins as lines that each have a stroke or a drawing.
bool begins_as_lines_of_strokes(std::string_view text) {
  TextWindow window(text);
  if (!begins_as_json_lines(window, lists_of_strokes)) return false;
  constexpr std::string_view x = "\"x\"";
  const std::string_view first = text.substr(0, text.size() - window.text().size());
  const std::size_t at_x = first.find(x);
  std::string_view behind_x = at_x == first.npos ? std::string_view() : first.substr(at_x + x.size());
  const auto has = [&](std::string_view name) { return first.find(name) != first.npos; };
  return has("\"points\"") || has("\"pointers\"") || has("\"drawing\"") ||
         (take_character(behind_x, ':') && take_character(behind_x, '['));
}

/// Whether a text begins as a list of points, or of strokes of points, that are lists of numbers.
bool begins_with_points_of_numbers(std::string_view text) {
  std::size_t lists = 0;
  while (take_character(text, '[')) ++lists;
  constexpr std::size_t most_numbers = 4;
  std::size_t numbers = 0;
  double number = 0;
  do {
    skip_blanks(text);
    numbers += take_number(text, number);
  } while (take_character(text, ',') && numbers <= most_numbers);
  const bool point = numbers >= 2 && numbers <= most_numbers && take_character(text, ']');
  return point && (lists == 2 || (lists == 3 && take_character(text, ',') && take_character(text, '[')));
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
  if (begins_with_lists_of_points(text) || begins_with_points_of_numbers(text) ||
      begins_as_lines_of_strokes(text))
    return true;
  if (text.starts_with('[')) return has_key_early(text, "\"pointers\"") || has_key_early(text, "\"points\"");
  return text.starts_with('{') &&
         (has_key_early(text, "\"strokes\"") || has_key_early(text, "\"pointers\"") ||
          has_key_early(text, "\"drawing\"") ||
          (has_key_early(text, "\"events\"") && has_key_early(text, "\"points\"")));
}

PenFile read_pointers(const PenFileText& file) {
  PenFile content;
  const auto read = [&](TextWindow& text, PenFile& to) { return read_by_strokes(file, text, to); };
  TextWindow window(file);
  if (begins_as_json_lines(window, lists_of_strokes)) {
    content = read_lines(file);
  } else if (auto strokes = pen_file_by_parts(file, read)) {
    content = std::move(*strokes);
  } else {
    read_whole(pen_json(file), content);
  }
  content.unit = "px";
  leave_out_dead_pressure(content);
  return content;
}

}  // namespace burin
