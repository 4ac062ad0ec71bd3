// Reads strokes as perfect-freehand takes them: a JSON object of named lists of points, [x, y],
// [x, y, pressure], [x, y, pressure, time in milliseconds] or {"x", "y", "pressure"}. Positions are pixels. A
// stroke has the channels that all its points have; a pressure of 0.5 throughout is what browsers tell of
// devices without.
#include <burin/base/text/json_value.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace burin {
namespace {

/// A point and what it has.
struct Point {
  Sample sample;
  bool pressure = false, time = false;
};

Point point_of(const JsonValue& value) {
  Point point;
  Sample& sample = point.sample;
  if (value.is_object()) {
    sample.position = {value.member("x").number(), value.member("y").number(), 0};
    const auto pressure = value.find("pressure");
    point.pressure = pressure.has_value();
    if (pressure) sample.pen.pressure = static_cast<float>(pressure->number());
    return point;
  }
  if (!value.is_array() || value.size() < 2) value.reject_type("a list of x and y");
  sample.position = {value.number_at(0), value.number_at(1), 0};
  point.pressure = value.size() > 2;
  point.time = value.size() > 3;
  if (point.pressure) sample.pen.pressure = static_cast<float>(value.number_at(2));
  if (point.time) sample.time = value.number_at(3) / 1000;
  return point;
}

PenStroke stroke_of(const JsonValue& list) {
  PenStroke stroke;
  stroke.fields = {.time = true, .pressure = true};
  stroke.made_pressure = true;
  constexpr float of_no_device = 0.5F;
  for (const JsonValue& value : list.items()) {
    const Point point = point_of(value);
    stroke.fields.pressure &= point.pressure;
    stroke.fields.time &= point.time;
    stroke.made_pressure &= point.sample.pen.pressure == of_no_device;
    stroke.samples.push_back(point.sample);
  }
  stroke.made_pressure &= stroke.fields.pressure;
  for (Sample& sample : stroke.samples) {
    if (!stroke.fields.pressure) sample.pen.pressure = Pen{}.pressure;
    if (!stroke.fields.time) sample.time = 0;
  }
  return stroke;
}

}  // namespace

bool is_point_lists(std::string_view text) {
  const auto take = [&text](char expected) { return take_character(text, expected); };
  if (!take('{') || !take('"')) return false;
  text.remove_prefix(std::min(text.find('"'), text.size()));
  return take('"') && take(':') && take('[') && (take('[') || take('{'));
}

PenFile read_point_lists(const PenFileText& file) {
  // By their names, as far as there are any of the same.
  std::multimap<std::string, PenStroke> strokes;
  auto content = pen_file_by_parts([&](PenFile&) {
    return for_each_json_part(file.text, [&](std::string_view name, std::string_view part) {
      strokes.emplace(name, stroke_of(pen_json_part(file, part)));
      return true;
    });
  });
  if (!content) {
    strokes.clear();
    for (const auto& [name, list] : pen_json(file).members()) strokes.emplace(name, stroke_of(list));
    content.emplace();
  }
  for (auto& [name, stroke] : strokes)
    if (!stroke.samples.empty()) content->strokes.push_back(std::move(stroke));
  content->unit = "px";
  content->millimetres = millimetres_a_pixel;
  return std::move(*content);
}

}  // namespace burin
