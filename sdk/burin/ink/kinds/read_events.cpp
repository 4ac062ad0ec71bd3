// Reads recordings of events that stroke/files/pen_events.h describes: of libmypaint, SVC, and arrays or
// lists of PointerEvents. They have no first bytes of their own, but lines of so many numbers, or such names.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/ink/decode/pointer_event_list.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/text_window.h>
#include <burin/ink/pen_file.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/recording.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Removes the first line; returns how many numbers it has, or 0 if it has anything else.
std::size_t take_numbers_of_line(std::string_view& text) {
  std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  std::size_t count = 0;
  double number = 0;
  for (skip_blanks(line); !line.empty(); skip_blanks(line), ++count)
    if (!take_number(line, number)) return 0;
  return count;
}

PenFile pen_file_of(ContactStrokes strokes, const PenFields& fields, std::string_view unit) {
  PenFile content;
  content.unit = unit;
  content.hovering = strokes.lifted();
  for (ContactStroke& stroke : strokes.take_strokes()) {
    PenStroke& made = content.strokes.emplace_back();
    made.fields = fields;
    made.drawn_by.eraser = stroke.eraser;
    made.samples = std::move(stroke.samples);
  }
  return content;
}

PenFile pen_file_of(const PenEvents& recorded, std::string_view unit) {
  ContactStrokes strokes;
  for (const PenEvent& event : recorded.events) strokes.take(event);
  return pen_file_of(std::move(strokes), recorded.fields, unit);
}

/// Reads one array after the other. Returns false for whatever must be read as a whole.
bool read_columns(TextWindow& text, PenFile& content) {
  PointerColumns columns;
  const auto names = pointer_column_names();
  const auto take = [&](std::string_view name, TextWindow& json) {
    const std::string_view part = take_json_value(json);
    if (std::ranges::find(names, name) == names.end()) return nlohmann::json::accept(part);
    const auto [column, is_new] = columns.emplace(name, std::vector<double>());
    return is_new && append_numbers(part, column->second);
  };
  if (!for_each_json_part(text, take)) return false;
  use_first_names(columns);
  auto events = pointer_events(columns);
  columns.clear();
  if (events) content = pen_file_of(*events, "px");
  return events.has_value();
}

PenFile svc_file_of(ContactStrokes strokes, SvcUnits units) {
  const bool converted = units == SvcUnits::converted;
  const PenFields fields{.time = true, .pressure = converted, .tilt = true};
  PenFile content = pen_file_of(std::move(strokes), fields, converted ? "mm" : "");
  if (!converted) content.not_used.emplace_back("pressure of an unknown range");
  return content;
}

constexpr std::array<const char*, 7> svc_names = {"x",       "y",    "time",    "pen_status",
                                                  "azimuth", "tilt", "pressure"};

/// Whether a text begins as the JSON of BDALab's handwriting-sample: an object with meta data, and with data
/// that are the columns of an SVC file.
bool is_svc_json(std::string_view text) {
  constexpr std::size_t early = 4096;
  skip_blanks(text);
  text = text.substr(0, early);
  const auto has = [&](std::string_view name) { return text.find(name) != text.npos; };
  return text.starts_with('{') && (has("\"meta_data\"") || has("\"data\"")) && has("\"pen_status\"");
}

PenFile read_svc_json(const PenFileText& file) {
  const JsonValue data = pen_json(file).member("data");
  std::array<std::vector<double>, svc_names.size()> columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const JsonValue column = data.member(svc_names[i]);
    columns[i] = column.numbers();
    if (columns[i].size() != columns[0].size())
      column.reject(fmt::format("has {} values, x has {}", columns[i].size(), columns[0].size()));
  }
  const auto is_whole = [](double value) { return value == std::floor(value); };
  const std::vector<double>& pressures = columns.back();
  const bool of_device = std::ranges::all_of(pressures, is_whole) &&
                         std::ranges::any_of(pressures, [](double one) { return one > 1; });
  const SvcUnits units = of_device ? SvcUnits::of_device : SvcUnits::converted;
  ContactStrokes strokes;
  for (std::size_t i = 0; i < columns[0].size(); ++i) try {
      std::array<double, svc_names.size()> numbers{};
      for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = columns[k][i];
      strokes.take(svc_event(numbers, units));
    } catch (const Error& error) {
      data.reject(fmt::format("event {}: {}", i, error.what()));
    }
  return svc_file_of(std::move(strokes), units);
}

}  // namespace

bool is_mypaint(std::string_view text) {
  constexpr std::size_t numbers = 4;
  return take_numbers_of_line(text) == numbers;
}

PenFile read_mypaint(const PenFileText& file) {
  ContactStrokes strokes;
  for_each_line_of(file, [&](std::string_view line) { strokes.take(mypaint_event(line)); });
  return pen_file_of(std::move(strokes), {.time = true, .pressure = true}, "px");
}

bool is_svc(std::string_view text) {
  if (is_svc_json(text)) return true;
  constexpr std::size_t numbers = 7;
  return take_numbers_of_line(text) == 1 && take_numbers_of_line(text) == numbers;
}

PenFile read_svc(const PenFileText& file) {
  if (is_svc_json(file.text)) return read_svc_json(file);
  const SvcUnits units = svc_units(file.text);
  ContactStrokes strokes;
  std::optional<std::size_t> told;
  std::size_t count = 0;
  for_each_line_of(file, [&](std::string_view line) {
    if (!told) {
      told = svc_count(line);
      return;
    }
    strokes.take(svc_event(line, units));
    ++count;
  });
  if (count != told.value_or(0))
    throw FileError(file.path.string(), "1", fmt::format("{} lines are told, {} follow", *told, count));
  return svc_file_of(std::move(strokes), units);
}

bool is_pointer_arrays(std::string_view text) {
  const auto names = pointer_column_names();
  if (begins_as_event_list(text) || has_event_list(text)) return true;
  const auto take = [&text](char expected) { return take_character(text, expected); };
  if (!take('{') || !take('"')) return false;
  const std::string_view name = text.substr(0, text.find('"'));
  text.remove_prefix(name.size());
  return std::ranges::find(names, name) != names.end() && take('"') && take(':') && take('[');
}

PenFile read_pointer_arrays(const PenFileText& file) {
  if (begins_as_event_list(file.text) || has_event_list(file.text)) return read_event_list(file);
  if (auto content = pen_file_by_parts(file, read_columns)) return std::move(*content);
  const PenFileText whole = file.rest_at == 0 ? file : whole_pen_file(file.path);
  check_json_bounds(whole);
  return pen_file_of(pointer_events(whole.text, whole.path), "px");
}

}  // namespace burin
