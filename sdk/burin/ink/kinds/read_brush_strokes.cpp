// Reads the `stroke` lists that Blender's operators take, as scripts and its information editor show them:
//   bpy.ops.sculpt.brush_stroke(stroke=[{"name": "", "location": (x, y, z), "mouse": (x, y), "pressure": 1,
//     "size": 50, "pen_flip": False, "time": 0, "is_start": True, ...}, ...])
// or the list alone, in Python or JSON. "mouse" is in pixels of the region, y up; "time" is in seconds;
// "size" the radius of the brush in pixels. "is_start" begins another stroke.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/base/vector.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/python_literal.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace burin {
namespace {

/// Calls `take` with the lists of strokes in a text: what follows each "stroke=", or all of it, and the
/// number of lines before it.
template <class Take>
void for_each_list(std::string_view text, const Take& take) {
  constexpr std::string_view argument = "stroke=";
  std::size_t counted = 0, lines = 0;
  for (std::size_t at = 0; (at = text.find(argument, at)) != text.npos;) {
    const std::size_t begin = at + argument.size();
    int depth = 0;
    std::size_t end = begin;
    for (; end < text.size(); ++end) {
      if (text[end] == '[' || text[end] == '(') ++depth;
      if ((text[end] == ']' || text[end] == ')') && --depth <= 0) break;
    }
    const std::string_view before = text.substr(counted, begin - counted);
    lines += static_cast<std::size_t>(std::ranges::count(before, '\n'));
    counted = begin;
    take(text.substr(begin, end + 1 - begin), lines);
    at = end;
  }
  if (counted == 0) take(text, 0);
}

bool flag(const JsonValue& element, const char* name) {
  const auto found = element.find(name);
  return found && found->is_boolean() && found->boolean();
}

/// Whether the elements move in object space: then "mouse" may be missing or the same everywhere.
bool has_mouse(const std::vector<JsonValue>& elements) {
  return std::ranges::all_of(elements, [](const JsonValue& one) { return one.find("mouse").has_value(); });
}

std::vector<double> place_of(const JsonValue& element, bool mouse) {
  const JsonValue place = element.member(mouse ? "mouse" : "location");
  std::vector<double> numbers = place.numbers();
  const std::size_t needed = mouse ? 2 : 3;
  if (numbers.size() < needed)
    place.reject(fmt::format("has {} numbers, a place needs {}", numbers.size(), needed));
  return numbers;
}

Sample sample_of(const JsonValue& element, bool mouse) {
  Sample sample;
  const std::vector<double> place = place_of(element, mouse);
  sample.position = mouse ? Vec3d(place[0], -place[1], 0) : Vec3d(place[0], place[1], place[2]);
  if (const auto time = element.find("time")) sample.time = time->number();
  if (const auto pressure = element.find("pressure"))
    sample.pen.pressure = static_cast<float>(pressure->number());
  if (const auto x_tilt = element.find("x_tilt"))  // a share of a right angle
    sample.pen.tilt_x = static_cast<float>(x_tilt->number() * std::numbers::pi / 2);
  if (const auto y_tilt = element.find("y_tilt"))
    sample.pen.tilt_y = static_cast<float>(y_tilt->number() * std::numbers::pi / 2);
  return sample;
}

void read_list(const JsonValue& list, PenFile& content) {
  const std::vector<JsonValue> elements = list.items();
  const bool mouse = has_mouse(elements);
  const auto all_have = [&](const char* name) {
    return std::ranges::all_of(elements, [&](const JsonValue& one) { return one.find(name).has_value(); });
  };
  const PenFields fields = {.time = all_have("time"),
                            .pressure = all_have("pressure"),
                            .tilt = all_have("x_tilt") && all_have("y_tilt"),
                            .twist = false};
  const bool sizes = all_have("size") && mouse;
  if (mouse) content.unit = "px";
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i == 0 || flag(elements[i], "is_start")) {
      PenStroke& stroke = content.strokes.emplace_back();
      stroke.fields = fields;
      stroke.has_z = !mouse;
      stroke.eraser = flag(elements[i], "pen_flip");
    }
    PenStroke& stroke = content.strokes.back();
    stroke.samples.push_back(sample_of(elements[i], mouse));
    if (sizes) stroke.widths.push_back(static_cast<float>(2 * elements[i].member("size").number()));
  }
}

/// Whether a text has this name in quotes before a colon.
bool has_key(std::string_view text, std::string_view name) {
  for (const char* quote : {"\"", "'"}) {
    const std::string quoted = quote + std::string(name) + quote;
    for (std::size_t at = 0; (at = text.find(quoted, at)) != text.npos;) {
      at += quoted.size();
      std::string_view behind = text.substr(at);
      if (take_character(behind, ':')) return true;
    }
  }
  return false;
}

}  // namespace

bool is_brush_strokes(std::string_view text) {
  const std::string_view head = text.substr(0, 65536);
  return (head.find("stroke=") != head.npos || head.find_first_not_of(blanks) == head.find('[')) &&
         (has_key(head, "mouse") || has_key(head, "location"));
}

PenFile read_brush_strokes(const PenFileText& file) {
  PenFile content;
  for_each_list(file.text, [&](std::string_view list, std::size_t lines) {
    const PenFileText json{file.path, json_of_python(list)};
    try {
      read_list(pen_json(json), content);
    } catch (const MalformedJson&) {
      // The message of the list after line breaks names the line of the file.
      pen_json({file.path, std::string(lines, '\n') + json.text});
      throw;
    }
  });
  return content;
}

}  // namespace burin
