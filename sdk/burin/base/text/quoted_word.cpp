// Makes text from files printable for messages.
#include <burin/base/text/quoted_word.h>
#include <burin/base/text/utf8.h>
#include <fmt/format.h>

namespace burin {
namespace {

constexpr std::size_t longest = 40;  ///< bytes

/// Removes a character, or a byte that is not UTF-8, from the front of a text, which must not be empty.
/// `plain`: whether it can be shown as it is.
std::string_view take_character(std::string_view& text, bool& plain) {
  std::string_view rest = text;
  const auto code = pop_code_point(rest);
  const std::string_view taken = text.substr(0, code ? text.size() - rest.size() : 1);
  plain = code && !is_control(*code);
  text.remove_prefix(taken.size());
  return taken;
}

void append_shown(std::string& line, std::string_view character, bool plain) {
  if (plain)
    line += character;
  else
    for (const char byte : character) line += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
}

}  // namespace

std::string quoted_word(std::string_view word) {
  std::string text;
  for (std::size_t bytes = 0; !word.empty();) {
    bool plain = false;
    const std::string_view character = take_character(word, plain);
    bytes += character.size();
    if (bytes > longest) return fmt::format("'{}...'", text);
    append_shown(text, character, plain);
  }
  return fmt::format("'{}'", text);
}

std::string printable(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    bool plain = false;
    const std::string_view character = take_character(text, plain);
    append_shown(line, character, plain);
  }
  return line;
}

}  // namespace burin
