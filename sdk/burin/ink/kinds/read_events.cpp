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
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

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
  constexpr std::size_t numbers = 7;
  return take_numbers_of_line(text) == 1 && take_numbers_of_line(text) == numbers;
}

PenFile read_svc(const PenFileText& file) {
  ContactStrokes strokes;
  std::optional<std::size_t> told;
  std::size_t count = 0;
  for_each_line_of(file, [&](std::string_view line) {
    if (!told) {
      told = svc_count(line);
      return;
    }
    strokes.take(svc_event(line));
    ++count;
  });
  if (count != told.value_or(0))
    throw FileError(file.path.string(), "1", fmt::format("{} lines are told, {} follow", *told, count));
  return pen_file_of(std::move(strokes), {.time = true, .pressure = true, .tilt = true}, "mm");
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
