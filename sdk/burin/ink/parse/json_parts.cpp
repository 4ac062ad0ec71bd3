#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/scan.h>

namespace burin {
namespace {

/// Where the text in quotes that begins a string of JSON ends; its size if it has no end.
std::size_t end_of_text(std::string_view json) {
  for (std::size_t i = 1; i < json.size(); ++i) {
    if (json[i] == '\\')
      ++i;
    else if (json[i] == '"')
      return i + 1;
  }
  return json.size();
}

std::size_t end_of_brackets(std::string_view json) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < json.size();) {
    const char c = json[i];
    if (c == '"') {
      i += end_of_text(json.substr(i));
      continue;
    }
    ++i;
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && --depth == 0) return i;
  }
  return json.size();
}

/// Removes a value from the front of a text.
std::string_view take_value(std::string_view& json) {
  skip_blanks(json);
  std::size_t end = 0;
  if (json.starts_with('"'))
    end = end_of_text(json);
  else if (json.starts_with('[') || json.starts_with('{'))
    end = end_of_brackets(json);
  else
    end = std::min(json.find_first_of(",]} \t\r\n"), json.size());
  const std::string_view value = json.substr(0, end);
  json.remove_prefix(end);
  return value;
}

}  // namespace

bool for_each_json_part(std::string_view json,
                        const std::function<bool(std::string_view name, std::string_view part)>& take) {
  const bool object = take_character(json, '{');
  if (!object && !take_character(json, '[')) return false;
  const char end = object ? '}' : ']';
  constexpr std::size_t most_parts = 500'000;
  for (std::size_t number = 0; !take_character(json, end); ++number) {
    if (number == most_parts || (number > 0 && !take_character(json, ','))) return false;
    std::string_view name = object ? take_value(json) : std::string_view();
    if (object && (name.size() < 2 || name.front() != '"' || !take_character(json, ':'))) return false;
    if (object) name = name.substr(1, name.size() - 2);
    const std::string_view part = take_value(json);
    if (part.empty() || !take(name, part)) return false;
  }
  skip_blanks(json);
  return json.empty();
}

}  // namespace burin
