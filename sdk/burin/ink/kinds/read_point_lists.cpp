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
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// A point and what it has.
struct Point {
  Sample sample;
  bool pressure = false, time = false;
};

/// The point of two numbers or more: x, y, pressure, time.
Point point_of(std::span<const double> numbers) {
  Point point;
  Sample& sample = point.sample;
  sample.position = {numbers[0], numbers[1], 0};
  point.pressure = numbers.size() > 2;
  point.time = numbers.size() > 3;
  if (point.pressure) sample.pen.pressure = static_cast<float>(numbers[2]);
  if (point.time) sample.time = numbers[3] / 1000;
  return point;
}

Point point_of(const JsonValue& value) {
  if (value.is_array() && value.size() >= 2) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < std::min<std::size_t>(value.size(), 4); ++i)
      numbers.push_back(value.number_at(i));
    return point_of(numbers);
  }
  if (!value.is_object()) value.reject_type("a list of x and y");
  Point point;
  point.sample.position = {value.member("x").number(), value.member("y").number(), 0};
  const auto pressure = value.find("pressure");
  point.pressure = pressure.has_value();
  if (pressure) point.sample.pen.pressure = static_cast<float>(pressure->number());
  return point;
}

/// A stroke of points that are added one after the other.
class ListedStroke {
 public:
  ListedStroke() {
    stroke_.fields = {.time = true, .pressure = true};
    stroke_.made_pressure = true;
  }

  void reserve(std::size_t count) { stroke_.samples.reserve(count); }

  void add(const Point& point) {
    constexpr float of_no_device = 0.5F;
    stroke_.fields.pressure &= point.pressure;
    stroke_.fields.time &= point.time;
    stroke_.made_pressure &= point.sample.pen.pressure == of_no_device;
    stroke_.samples.push_back(point.sample);
  }

  PenStroke finish() {
    stroke_.made_pressure &= stroke_.fields.pressure;
    for (Sample& sample : stroke_.samples) {
      if (!stroke_.fields.pressure) sample.pen.pressure = Pen{}.pressure;
      if (!stroke_.fields.time) sample.time = 0;
    }
    return std::move(stroke_);
  }

 private:
  PenStroke stroke_;
};

PenStroke listed_stroke(const JsonValue& list) {
  ListedStroke stroke;
  for (const JsonValue& value : list.items()) stroke.add(point_of(value));
  return stroke.finish();
}

/// Calls `take` with the numbers of each point of a list of lists of numbers. Returns false for other lists.
template <class Take>
bool for_each_plain_point(std::string_view json, const Take& take) {
  std::vector<double> numbers;
  return for_each_json_part(json, [&](std::string_view, std::string_view part) {
    numbers.clear();
    if (!append_numbers(part, numbers) || numbers.size() < 2) return false;
    take(numbers);
    return true;
  });
}

/// The stroke of such a list, in a fraction of the time; nothing of other lists, which take no memory.
std::optional<PenStroke> plain_stroke(std::string_view json) {
  std::size_t count = 0;
  if (!for_each_plain_point(json, [&](const std::vector<double>&) { ++count; })) return std::nullopt;
  ListedStroke stroke;
  stroke.reserve(count);
  for_each_plain_point(json, [&](const std::vector<double>& numbers) { stroke.add(point_of(numbers)); });
  return stroke.finish();
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
  auto content = pen_file_by_parts(file, [&](TextWindow& text, PenFile&) {
    return for_each_json_part(text, [&](std::string_view name, TextWindow& json) {
      const std::string_view part = take_json_value(json);
      auto plain = plain_stroke(part);
      strokes.emplace(name, plain ? std::move(*plain) : listed_stroke(pen_json_part(file, part)));
      return true;
    });
  });
  if (!content) {
    strokes.clear();
    for (const auto& [name, list] : pen_json(file).members()) strokes.emplace(name, listed_stroke(list));
    content.emplace();
  }
  for (auto& [name, stroke] : strokes)
    if (!stroke.samples.empty()) content->strokes.push_back(std::move(stroke));
  content->unit = "px";
  content->millimetres = millimetres_a_pixel;
  return std::move(*content);
}

}  // namespace burin
