// Rewrites the text of a literal in one pass, so that the JSON reader does the rest.
#include <burin/ink/parse/python_literal.h>

#include <algorithm>
#include <cctype>

namespace burin {
namespace {

/// Copies a text in single or double quotes, which begins at `at`; returns where it ends.
std::size_t copy_text(std::string_view literal, std::size_t at, std::string& json) {
  const char quote = literal[at];
  json += '"';
  for (++at; at < literal.size() && literal[at] != quote; ++at) {
    if (literal[at] == '\\' && at + 1 < literal.size()) {
      if (literal[at + 1] != '\'') json += '\\';
      ++at;
    } else if (literal[at] == '"') {
      json += '\\';
    }
    json += literal[at];
  }
  json += '"';
  return at;
}

void close_bracket(std::string& json, char bracket) {
  const std::size_t last = json.find_last_not_of(" \t\r\n");
  if (last != json.npos && json[last] == ',') json[last] = ' ';
  json += bracket;
}

/// Copies a name or number, which begins at `at`; returns where it ends.
std::size_t copy_word(std::string_view literal, std::size_t at, std::string& json) {
  const std::size_t end = std::min(literal.find_first_of(" \t\r\n,:()[]{}'\"", at), literal.size());
  const std::string_view word = literal.substr(at, end - at);
  json += word == "True" ? "true" : word == "False" ? "false" : word == "None" ? "null" : word;
  return end - 1;
}

}  // namespace

std::string json_of_python(std::string_view literal) {
  std::string json;
  json.reserve(literal.size());
  for (std::size_t at = 0; at < literal.size(); ++at) {
    const char c = literal[at];
    if (c == '\'' || c == '"')
      at = copy_text(literal, at, json);
    else if (c == '(')
      json += '[';
    else if (c == ')' || c == ']' || c == '}')
      close_bracket(json, c == ')' ? ']' : c);
    else if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
      at = copy_word(literal, at, json);
    else
      json += c;
  }
  return json;
}

}  // namespace burin
