#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

namespace burin {

inline constexpr std::string_view blanks = " \t\r\n\f\v";

inline bool is_blank(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }

/// Removes blanks from the front of a text.
inline void skip_blanks(std::string_view& text) {
  std::size_t count = 0;
  while (count < text.size() && is_blank(text[count])) ++count;
  text.remove_prefix(count);
}

/// Removes blanks and then this character from the front of a text. Returns false, and leaves what follows
/// the blanks, if another one is there.
inline bool take_character(std::string_view& text, char expected) {
  skip_blanks(text);
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(1);
  return true;
}

/// Removes a finite number from the front of a text, which may begin with a plus sign. Returns false, and
/// leaves the text, if there is none.
inline bool take_number(std::string_view& text, double& value) {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return true;
}

/// Removes a whole number of this base from the front of a text. Returns false, and leaves the text, if there
/// is none.
template <class Whole>
bool take_whole(std::string_view& text, Whole& value, int base = 10) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return true;
}

/// Removes the next word, up to a blank, from the front of a text.
inline std::string_view take_word(std::string_view& text) {
  skip_blanks(text);
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

/// Reads all of a word as a whole number of this base. Returns false if it is none.
template <class Whole>
bool read_whole(std::string_view word, Whole& value, int base = 10) {
  return take_whole(word, value, base) && word.empty();
}

}  // namespace burin
