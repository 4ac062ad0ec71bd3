// Bounds JSON before it is parsed: a short text can make a tree of many times its size.
#include <burin/base/error.h>
#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/pen_json.h>
#include <burin/ink/parse/unpack.h>

#include <algorithm>

namespace burin {
namespace {

constexpr int deepest_json = 200;
constexpr std::size_t most_tree_bytes = 56'000'000;
// What nlohmann::json and the JsonValue of each item take, as measured.
constexpr std::size_t value_bytes = 24, member_bytes = 100, container_bytes = 100;

void check_bounds(std::string_view text, const std::string& path) {
  bool in_text = false;
  int depth = 0;
  std::size_t tree = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_text = !in_text;
    } else if (in_text) {
      continue;
    } else if (c == '[' || c == '{') {
      tree += container_bytes;
      if (++depth > deepest_json) throw FileError(path, "JSON nested deeper than 200 levels");
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',') {
      tree += value_bytes;
    } else if (c == ':') {
      tree += member_bytes;
    }
  }
  if (tree > most_tree_bytes) throw FileError(path, "more values of JSON than 56 MB hold");
}

}  // namespace

void check_json_bounds(const PenFileText& file) { check_bounds(file.text, file.path.string()); }

JsonValue pen_json_part(const PenFileText& file, std::string_view part) {
  check_bounds(part, file.path.string());
  return JsonValue::parse(part, file.path.string());
}

bool begins_as_json_lines(TextWindow& text, std::span<const std::string_view> whole) {
  if (!text.skip_blanks() || !text.text().starts_with('{')) return false;
  const bool one = for_each_json_part(text, [&](std::string_view name, TextWindow& json) {
    if (std::ranges::find(whole, name) != whole.end()) return false;
    take_json_value(json);
    return true;
  });
  return one && text.skip_blanks() && text.text().starts_with('{');
}

void for_each_json_value(const PenFileText& file, const std::function<bool(std::string_view text)>& take,
                         const std::function<void(const JsonValue& value)>& take_parsed) {
  const std::string path = file.path.string();
  for (TextWindow text(file); text.skip_blanks();) {
    const std::uintmax_t place = text.place();
    const std::string_view value = take_json_value(text);
    if (!value.empty() && take(value)) continue;
    try {
      take_parsed(pen_json_part(file, value));
    } catch (const FileError&) {
      take_parsed(JsonValue::parse_line(value, path, line_of(file, place)));
      throw;
    }
  }
}

std::optional<PenFile> pen_file_by_parts(
    const PenFileText& file, const std::function<bool(TextWindow& text, PenFile& content)>& read) {
  PenFile content;
  TextWindow text(file);
  try {
    if (read(text, content) && !text.skip_blanks()) return content;
  } catch (const FileError&) {
    // Reading it as a whole finds the place of the fault.
  }
  std::error_code none;
  if (file.rest_at != 0 && std::filesystem::file_size(file.path, none) > most_parsed_bytes)
    throw FileError(file.path.string(), std::to_string(line_of(file, text.place())),
                    "more than 60 MB of JSON that cannot be read stroke by stroke beyond this line");
  return std::nullopt;
}

JsonValue pen_json(const PenFileText& file) {
  if (file.rest_at == 0) return pen_json_part(file, file.text);
  return pen_json(whole_pen_file(file.path));
}

}  // namespace burin
