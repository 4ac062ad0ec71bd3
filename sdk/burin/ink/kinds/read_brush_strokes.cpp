// Reads the `stroke` lists that Blender's operators take, as scripts and its information editor show them:
//   bpy.ops.sculpt.brush_stroke(stroke=[{"name": "", "location": (x, y, z), "mouse": (x, y), "pressure": 1,
//     "size": 50, "pen_flip": False, "time": 0, "is_start": True, ...}, ...])
// or the list alone, in Python or JSON. "mouse" is in pixels of the region, y up; "time" is in seconds;
// "size" the radius of the brush in pixels. "is_start" begins another stroke. Scripts that tell of locations
// only leave the mouse at one place.
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
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr std::string_view argument = "stroke";

/// Removes all up to the list that the next "stroke=" or "stroke = " gives. Returns false if there is none.
bool skip_to_list(TextWindow& text) {
  for (;;) {
    const std::size_t size = text.text().size(), at = text.text().find(argument);
    if (at == text.text().npos) {
      text.remove_prefix(size - std::min(size, argument.size()));
      if (!text.grow()) return false;
      continue;
    }
    text.remove_prefix(at + argument.size());
    // A script may give a list by a name that it has given to it before.
    if (text.take_character('=') && text.skip_blanks() && text.text().starts_with('[')) return true;
  }
}

/// Whether a text gives something for "stroke".
bool gives_stroke(std::string_view text) {
  for (std::size_t at = text.find(argument); at != text.npos; at = text.find(argument)) {
    text.remove_prefix(at + argument.size());
    if (take_character(text, '=')) return true;
  }
  return false;
}

/// What one element of a list says. Places have two or three numbers.
struct ListElement {
  std::optional<Vec3d> mouse, location;
  std::optional<double> time, pressure, x_tilt, y_tilt, size;
  bool is_start = false, pen_flip = false;
};

/// The member that a name stands for; null for others.
std::optional<double> ListElement::*number_named(std::string_view name) {
  if (name == "time") return &ListElement::time;
  if (name == "pressure") return &ListElement::pressure;
  if (name == "x_tilt") return &ListElement::x_tilt;
  if (name == "y_tilt") return &ListElement::y_tilt;
  return name == "size" ? &ListElement::size : nullptr;
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
ListElement element_of(const JsonValue& json, bool mouse) {
  ListElement element;
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

/// Reads a member of an element without a tree of JSON values. Returns false if it is not as it should be.
/// `numbers`: memory for those of places.
bool take_member(std::string_view name, std::string_view part, std::vector<double>& numbers,
                 ListElement& element) {
  if (const auto number = number_named(name)) {
    double value = 0;
    if (!take_number(part, value) || !part.empty()) return false;
    element.*number = value;
  }
  const bool mouse = name == "mouse", location = name == "location";
  if (mouse || location) {
    numbers.clear();
    if (!append_numbers(part, numbers, PartSyntax::python) || numbers.size() < (mouse ? 2U : 3U))
      return false;
    numbers.resize(3);
    (mouse ? element.mouse : element.location) = Vec3d(numbers[0], numbers[1], numbers[2]);
  }
  if (name == "is_start") element.is_start = part == "True" || part == "true";
  if (name == "pen_flip") element.pen_flip = part == "True" || part == "true";
  return true;
}

Sample sample_of(const ListElement& element, bool mouse) {
  Sample sample;
  sample.position = mouse ? Vec3d(element.mouse->x(), -element.mouse->y(), 0) : *element.location;
  sample.time = element.time.value_or(0);
  if (element.pressure) sample.pen.pressure = static_cast<float>(*element.pressure);
  constexpr double right_angle = std::numbers::pi / 2;  // tilts are shares of it
  if (element.x_tilt) sample.pen.tilt_x = static_cast<float>(*element.x_tilt * right_angle);
  if (element.y_tilt) sample.pen.tilt_y = static_cast<float>(*element.y_tilt * right_angle);
  return sample;
}

/// Makes strokes of the elements of a list. They have what all its elements have.
class ListOfElements {
 public:
  /// `mouse`: whether positions are those of the mouse.
  ListOfElements(bool mouse, PenFile& content)
      : mouse_(mouse), first_(content.strokes.size()), content_(content) {}

  void take(const ListElement& element);
  void finish();
  /// Whether the mouse rests where the brush moves, as in scripts that tell of locations only.
  bool rests() const { return located_ && location_moves_ && !mouse_moves_; }

 private:
  bool mouse_;
  std::size_t first_;  ///< stroke of the list
  PenFields fields_{.time = true, .pressure = true, .tilt = true, .twist = false};
  bool sizes_ = true;
  bool any_ = false, located_ = true, mouse_moves_ = false, location_moves_ = false;
  Vec3d first_mouse_ = Vec3d::Zero(), first_location_ = Vec3d::Zero();
  PenFile& content_;
};

void ListOfElements::take(const ListElement& element) {
  const Vec3d mouse = element.mouse.value_or(Vec3d::Zero()),
              location = element.location.value_or(Vec3d::Zero());
  if (!std::exchange(any_, true)) {
    first_mouse_ = mouse;
    first_location_ = location;
  }
  located_ &= element.location.has_value();
  mouse_moves_ |= mouse != first_mouse_;
  location_moves_ |= location != first_location_;
  if (content_.strokes.size() == first_ || element.is_start)
    content_.strokes.emplace_back().drawn_by.eraser = element.pen_flip;
  PenStroke& stroke = content_.strokes.back();
  stroke.samples.push_back(sample_of(element, mouse_));
  if (element.size) stroke.widths.push_back(static_cast<float>(2 * *element.size));
  fields_.time &= element.time.has_value();
  fields_.pressure &= element.pressure.has_value();
  fields_.tilt &= element.x_tilt && element.y_tilt;
  sizes_ &= element.size.has_value();
}

void ListOfElements::finish() {
  if (mouse_) content_.unit = "px";
  for (std::size_t i = first_; i < content_.strokes.size(); ++i) {
    content_.strokes[i].fields = fields_;
    content_.strokes[i].has_z = !mouse_;
    if (!sizes_ || !mouse_) content_.strokes[i].widths.clear();
  }
}

/// Throws FileError that names the fault of the element that begins at `place`, the `number`-th of its list.
[[noreturn]] void reject_element(const PenFileText& file, std::uintmax_t place, std::size_t number,
                                 bool mouse) {
  const std::string line = std::to_string(line_of(file, place));
  TextWindow text(file);
  text.go_to(place);
  const std::string json = json_of_python(take_json_value(text));
  try {
    element_of(pen_json_part({fmt::format("{}:{}: element {}", file.path.string(), line, number), {}}, json),
               mouse);
  } catch (const MalformedJson&) {
  }
  throw FileError(file.path.string(), line, fmt::format("element {} is malformed", number));
}

/// Adds the strokes of the list at the front of the text. Returns false, and adds nothing, if places of the
/// mouse are asked for, and an element has none or the mouse rests.
bool append_list(const PenFileText& file, TextWindow& text, bool mouse, PenFile& content) {
  const std::size_t strokes = content.strokes.size();
  ListOfElements list(mouse, content);
  std::size_t number = 0;
  bool placed = true;
  std::vector<double> numbers;
  const auto take = [&](std::string_view, TextWindow& json) {
    const std::uintmax_t place = json.skip_blanks() ? json.place() : 0;
    ListElement element;
    ++number;
    const auto take_part = [&](std::string_view name, TextWindow& part) {
      return take_member(name, take_json_value(part), numbers, element);
    };
    if (!json.text().starts_with('{') || !for_each_json_part(json, take_part, PartSyntax::python))
      reject_element(file, place, number, mouse);
    placed = mouse ? element.mouse.has_value() : element.location.has_value();
    if (!placed && !mouse) reject_element(file, place, number, mouse);
    if (placed) list.take(element);
    return placed;
  };
  const bool whole = for_each_json_part(text, take, PartSyntax::python);
  if (!placed || (mouse && whole && list.rests())) {
    content.strokes.resize(strokes);
    return false;
  }
  if (!whole)
    throw FileError(file.path.string(), std::to_string(line_of(file, text.place())), "malformed list");
  list.finish();
  return true;
}

void read_list(const PenFileText& file, TextWindow& text, PenFile& content) {
  const std::uintmax_t place = text.place();
  if (append_list(file, text, true, content)) return;
  text.go_to(place);
  append_list(file, text, false, content);
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
  return (gives_stroke(head) || head.find_first_not_of(blanks) == head.find('[')) &&
         (has_key(head, "mouse") || has_key(head, "location"));
}

PenFile read_brush_strokes(const PenFileText& file) {
  PenFile content;
  TextWindow text(file);
  bool any = false;
  for (; skip_to_list(text); any = true) read_list(file, text, content);
  if (any) return content;
  text.go_to(0);
  read_list(file, text, content);
  return content;
}

}  // namespace burin
