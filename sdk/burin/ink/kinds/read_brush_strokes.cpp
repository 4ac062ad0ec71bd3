// Reads the `stroke` lists that Blender's operators take, as scripts and its information editor show them:
//   bpy.ops.sculpt.brush_stroke(stroke=[{"name": "", "location": (x, y, z), "mouse": (x, y), "pressure": 1,
//     "size": 50, "pen_flip": False, "time": 0, "is_start": True, ...}, ...])
// or the list alone, in Python or JSON. "mouse" is in pixels of the region, y up; "time" is in seconds;
// "size" the radius of the brush in pixels. "is_start" begins another stroke.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/base/vector.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/python_literal.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

/// What one element of a list says. Places have two or three numbers.
struct Element {
  std::optional<Vec3d> mouse, location;
  std::optional<double> time, pressure, x_tilt, y_tilt, size;
  bool is_start = false, pen_flip = false;
};

/// The member that a name stands for; null for others.
std::optional<double> Element::*number_named(std::string_view name) {
  if (name == "time") return &Element::time;
  if (name == "pressure") return &Element::pressure;
  if (name == "x_tilt") return &Element::x_tilt;
  if (name == "y_tilt") return &Element::y_tilt;
  return name == "size" ? &Element::size : nullptr;
}

std::optional<Vec3d> place_in(const JsonValue& element, const char* name, std::size_t needed) {
  const auto place = element.find(name);
  if (!place) return std::nullopt;
  std::vector<double> numbers = place->numbers();
  if (numbers.size() < needed)
    place->reject(fmt::format("has {} numbers, a place needs {}", numbers.size(), needed));
  numbers.resize(3);
  return Vec3d(numbers[0], numbers[1], numbers[2]);
}

/// Reads an element. `mouse`: whether the places are those of the mouse.
Element element_of(const JsonValue& json, bool mouse) {
  Element element;
  (mouse ? element.mouse : element.location) =
      mouse ? place_in(json, "mouse", 2) : place_in(json, "location", 3);
  if (!element.mouse && !element.location) json.member("location");
  for (const char* name : {"time", "pressure", "x_tilt", "y_tilt", "size"})
    if (const auto found = json.find(name)) element.*number_named(name) = found->number();
  const auto flag = [&](const char* name) {
    const auto found = json.find(name);
    return found && found->is_boolean() && found->boolean();
  };
  element.is_start = flag("is_start");
  element.pen_flip = flag("pen_flip");
  return element;
}

std::vector<Element> elements_of(const JsonValue& list) {
  const std::vector<JsonValue> items = list.items();
  const bool mouse =
      std::ranges::all_of(items, [](const JsonValue& one) { return one.find("mouse").has_value(); });
  std::vector<Element> elements;
  for (const JsonValue& item : items) elements.push_back(element_of(item, mouse));
  return elements;
}

/// The numbers of a list of so many or more, up to three.
std::optional<Vec3d> place_in(std::string_view json, std::size_t needed) {
  Vec3d place = Vec3d::Zero();
  std::size_t count = 0;
  const bool whole = for_each_json_part(json, [&](std::string_view, std::string_view part) {
    double number = 0;
    if (!take_number(part, number) || !part.empty()) return false;
    if (count < 3) place[static_cast<Eigen::Index>(count)] = number;
    ++count;
    return true;
  });
  return whole && count >= needed ? std::optional(place) : std::nullopt;
}

template <class Value>
bool all_have(const std::vector<Element>& elements, std::optional<Value> Element::*member) {
  return std::ranges::all_of(elements, [&](const Element& one) { return (one.*member).has_value(); });
}

/// Reads a member of an element without a tree of JSON values. Returns false if it is not as it should be.
bool take_member(std::string_view name, std::string_view part, Element& element) {
  if (const auto number = number_named(name)) {
    double value = 0;
    if (!take_number(part, value) || !part.empty()) return false;
    element.*number = value;
  }
  if (name == "mouse") return (element.mouse = place_in(part, 2)).has_value();
  if (name == "location") return (element.location = place_in(part, 3)).has_value();
  if (name == "is_start") element.is_start = part == "true";
  if (name == "pen_flip") element.pen_flip = part == "true";
  return true;
}

/// The elements of a list, read in a tenth of the time. Nothing if there is a fault, which elements_of()
/// names.
std::optional<std::vector<Element>> plain_elements(std::string_view list) {
  std::vector<Element> elements;
  const bool whole = for_each_json_part(list, [&](std::string_view, std::string_view part) {
    Element& element = elements.emplace_back();
    return part.starts_with('{') &&
           for_each_json_part(part, [&](std::string_view name, std::string_view value) {
             return take_member(name, value, element);
           });
  });
  const bool placed = all_have(elements, &Element::mouse) || all_have(elements, &Element::location);
  return whole && placed ? std::optional(std::move(elements)) : std::nullopt;
}

Sample sample_of(const Element& element, bool mouse) {
  Sample sample;
  sample.position = mouse ? Vec3d(element.mouse->x(), -element.mouse->y(), 0) : *element.location;
  sample.time = element.time.value_or(0);
  if (element.pressure) sample.pen.pressure = static_cast<float>(*element.pressure);
  constexpr double right_angle = std::numbers::pi / 2;  // tilts are shares of it
  if (element.x_tilt) sample.pen.tilt_x = static_cast<float>(*element.x_tilt * right_angle);
  if (element.y_tilt) sample.pen.tilt_y = static_cast<float>(*element.y_tilt * right_angle);
  return sample;
}

void append_strokes(const std::vector<Element>& elements, PenFile& content) {
  const bool mouse = all_have(elements, &Element::mouse);
  const PenFields fields = {
      .time = all_have(elements, &Element::time),
      .pressure = all_have(elements, &Element::pressure),
      .tilt = all_have(elements, &Element::x_tilt) && all_have(elements, &Element::y_tilt),
      .twist = false};
  const bool sizes = all_have(elements, &Element::size) && mouse;
  if (mouse) content.unit = "px";
  for (const Element& element : elements) {
    if (&element == &elements.front() || element.is_start) {
      PenStroke& stroke = content.strokes.emplace_back();
      stroke.fields = fields;
      stroke.has_z = !mouse;
      stroke.eraser = element.pen_flip;
    }
    PenStroke& stroke = content.strokes.back();
    stroke.samples.push_back(sample_of(element, mouse));
    if (sizes) stroke.widths.push_back(static_cast<float>(2 * *element.size));
  }
}

/// Appends the strokes of a list in Python, below so many lines of the file.
void read_list(const PenFileText& file, std::string_view list, std::size_t lines, PenFile& content) {
  const PenFileText json{file.path, json_of_python(list)};
  if (const auto elements = plain_elements(json.text)) return append_strokes(*elements, content);
  try {
    append_strokes(elements_of(pen_json(json)), content);
  } catch (const MalformedJson&) {
    // The message of the list after line breaks names the line of the file.
    pen_json({file.path, std::string(lines, '\n') + json.text});
    throw;
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
  for_each_list(file.text,
                [&](std::string_view list, std::size_t lines) { read_list(file, list, lines, content); });
  return content;
}

}  // namespace burin
