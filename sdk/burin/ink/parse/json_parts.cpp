#include <burin/ink/parse/json_parts.h>
#include <burin/ink/parse/scan.h>

#include <array>

namespace burin {
namespace {

/// Where the text in quotes that begins a value ends; its size if it has no end.
std::size_t end_of_text(std::string_view json) {
  for (std::size_t i = 1; i < json.size(); ++i) {
    if (json[i] == '\\')
      ++i;
    else if (json[i] == json[0])
      return i + 1;
  }
  return json.size();
}

/// Tells for each character whether it is one of these.
using Characters = std::array<bool, 256>;

constexpr Characters characters_of(std::string_view set) {
  Characters among{};
  for (const char c : set) among[static_cast<unsigned char>(c)] = true;
  return among;
}

constexpr Characters word_ends = characters_of(",:]}) \t\r\n\f\v"), structure = characters_of("\"'[{(]})");

/// Where the first of these characters is from `begin` on; the size of the text if there is none.
std::size_t find_any(std::string_view json, const Characters& among, std::size_t begin) {
  while (begin < json.size() && !among[static_cast<unsigned char>(json[begin])]) ++begin;
  return begin;
}

std::size_t end_of_brackets(std::string_view json) {
  std::size_t depth = 0;
  for (std::size_t i = 0; (i = find_any(json, structure, i)) < json.size();) {
    const char c = json[i];
    if (c == '"' || c == '\'') {
      i += end_of_text(json.substr(i));
      continue;
    }
    ++i;
    if (c == '[' || c == '{' || c == '(') ++depth;
    if ((c == ']' || c == '}' || c == ')') && --depth == 0) return i;
  }
  return json.size();
}

std::size_t end_of_value(std::string_view json) {
  const char c = json.empty() ? ' ' : json.front();
  if (c == '"' || c == '\'') return end_of_text(json);
  return c == '[' || c == '{' || c == '(' ? end_of_brackets(json) : find_any(json, word_ends, 0);
}

}  // namespace

std::string_view take_json_value(TextWindow& json) {
  json.skip_blanks();
  std::size_t end = 0;
  do {
    end = end_of_value(json.text());
  } while (end == json.text().size() && json.grow());
  const std::string_view value = json.text().substr(0, end);
  json.remove_prefix(end);
  return value;
}

bool append_numbers(std::string_view json, std::vector<double>& numbers, PartSyntax syntax) {
  const bool python = syntax == PartSyntax::python, tuple = python && json.starts_with('(');
  if (!take_character(json, tuple ? '(' : '[')) return false;
  const char end = tuple ? ')' : ']';
  for (bool first = true; !take_character(json, end); first = false) {
    if (!first && !take_character(json, ',')) return false;
    if (!first && python && take_character(json, end)) break;
    skip_blanks(json);
    if (!take_number(json, numbers.emplace_back())) return false;
  }
  return json.empty();
}

}  // namespace burin
