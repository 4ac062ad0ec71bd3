#pragma once
#include <burin/ink/parse/text_window.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The writing of a value: Python has tuples, quotes of two kinds and commas before a closing bracket too.
enum class PartSyntax { json, python };

/// Removes a value from the front of a text and returns its text, which is valid until the window grows;
/// empty if none is there. Follows brackets and quotes only.
std::string_view take_json_value(TextWindow& json);

/// Calls `take` with the name of each member of the object at the front of a text, or with an empty name for
/// each item of the array, and with the text, from whose front it must remove the value. Removes the object.
/// Returns false if there is neither or something else stands between the parts, or once `take` does.
template <class Take>
bool for_each_json_part(TextWindow& json, const Take& take, PartSyntax syntax = PartSyntax::json) {
  const bool python = syntax == PartSyntax::python, object = json.take_character('{');
  const bool tuple = !object && python && json.take_character('(');
  if (!object && !tuple && !json.take_character('[')) return false;
  const char end = object ? '}' : tuple ? ')' : ']';
  std::string name;
  for (bool first = true; !json.take_character(end); first = false) {
    if (!first && !json.take_character(',')) return false;
    if (!first && python && json.take_character(end)) return true;
    if (object) {
      const std::string_view quoted = take_json_value(json);
      const bool quotes = quoted.starts_with('"') || (python && quoted.starts_with('\''));
      if (quoted.size() < 2 || !quotes) return false;
      name = quoted.substr(1, quoted.size() - 2);
      if (!json.take_character(':')) return false;
    }
    const std::uintmax_t before = json.place();
    if (!take(std::string_view(name), json) || json.place() == before) return false;
  }
  return true;
}

/// Calls `take` with the name and the text of each part of the object or array that a text in memory is.
/// Returns false as above, and if something stands behind it.
template <class Take>
bool for_each_json_part(std::string_view json, const Take& take, PartSyntax syntax = PartSyntax::json) {
  TextWindow text(json);
  const auto take_part = [&](std::string_view name, TextWindow& part) {
    return take(name, take_json_value(part));
  };
  return for_each_json_part(text, take_part, syntax) && !text.skip_blanks();
}

/// Appends the numbers of the list, or of the tuple of Python, that a text is. Returns false if it is
/// anything else.
bool append_numbers(std::string_view json, std::vector<double>& numbers,
                    PartSyntax syntax = PartSyntax::json);

}  // namespace burin
