// Reads recordings of events that stroke/files/pen_events.h describes: of libmypaint, SVC, and arrays or
// lists of PointerEvents. They have no first bytes of their own, but lines of so many numbers, or such names.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/ink/decode/pointer_event_list.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/recording.h>

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

PenFile pen_file_of(const PenEvents& recorded, std::string_view unit) {
  PenFile content;
  content.unit = unit;
  for (RecordedStroke& stroke : contact_strokes(recorded, content.hovering)) {
    PenStroke& made = content.strokes.emplace_back();
    made.fields = stroke.fields;
    made.samples = std::move(stroke.samples);
  }
  return content;
}

/// Reads one array after the other. Returns false for whatever must be read as a whole.
bool read_columns(const PenFileText& file, PenFile& content) {
  PointerColumns columns;
  const auto names = pointer_column_names();
  const auto take = [&](std::string_view name, std::string_view part) {
    if (std::ranges::find(names, name) == names.end()) return nlohmann::json::accept(part);
    return columns.emplace(name, pen_json_part(file, part).numbers()).second;
  };
  if (!for_each_json_part(file.text, take)) return false;
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
  return pen_file_of(mypaint_events(file.text, file.path), "px");
}

bool is_svc(std::string_view text) {
  constexpr std::size_t numbers = 7;
  return take_numbers_of_line(text) == 1 && take_numbers_of_line(text) == numbers;
}

PenFile read_svc(const PenFileText& file) { return pen_file_of(svc_events(file.text, file.path), "mm"); }

bool is_pointer_arrays(std::string_view text) {
  const auto names = pointer_column_names();
  if (begins_as_event_list(text)) return true;
  const auto take = [&text](char expected) { return take_character(text, expected); };
  if (!take('{') || !take('"')) return false;
  const std::string_view name = text.substr(0, text.find('"'));
  text.remove_prefix(name.size());
  return std::ranges::find(names, name) != names.end() && take('"') && take(':') && take('[');
}

PenFile read_pointer_arrays(const PenFileText& file) {
  if (begins_as_event_list(file.text)) return read_event_list(file);
  auto content = pen_file_by_parts([&](PenFile& to) { return read_columns(file, to); });
  if (content) return std::move(*content);
  check_json_bounds(file);
  return pen_file_of(pointer_events(file.text, file.path), "px");
}

}  // namespace burin
