// Splits texts into lines and words, and parses numbers with std::from_chars, which does not depend on the
// locale.
#include <burin/surface/files/text_lines.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace burin {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr std::string_view blanks = " \t\v\f\r";

template <class Number>
std::from_chars_result read_whole(std::string_view word, Number& value) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ptr != word.data() + word.size()) result.ec = std::errc::invalid_argument;
  return result;
}

/// What older C libraries of Windows write for numbers that are not finite: 1.#QNAN, -1.#IND00, 1.#INF.
/// Returns nothing for other words.
std::optional<double> written_on_windows(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) word.remove_prefix(1);
  constexpr std::string_view start = "1.#";
  if (!word.starts_with(start)) return std::nullopt;
  word.remove_prefix(start.size());
  using Limits = std::numeric_limits<double>;
  if (word.starts_with("INF")) return negative ? -Limits::infinity() : Limits::infinity();
  if (word.starts_with("QNAN") || word.starts_with("SNAN") || word.starts_with("IND"))
    return Limits::quiet_NaN();
  return std::nullopt;
}

/// Where a comment begins in a line: at the first '#' that is not within such a number.
std::size_t comment_of(std::string_view line) {
  constexpr std::size_t digit_and_point = 2;
  std::size_t at = line.find('#');
  while (at != line.npos && at >= digit_and_point && written_on_windows(line.substr(at - digit_and_point)))
    at = line.find('#', at + 1);
  return at;
}

}  // namespace

TextLines::TextLines(std::string_view text) : text_(text) {
  if (text.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
}

std::optional<std::string_view> TextLines::next() {
  if (at_ >= text_.size()) return std::nullopt;
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  const std::string_view line = text_.substr(at_, end - at_);
  at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
  at_ = std::min(at_, text_.size());
  number_ = ++last_;
  return line;
}

std::optional<std::string_view> TextLines::next_joined() {
  joined_.clear();
  std::size_t first = 0;
  for (auto line = next(); line; line = next()) {
    if (first == 0) first = number_;
    number_ = first;
    const std::size_t comment = comment_of(*line);
    const bool commented = comment != std::string_view::npos;
    std::string_view text = line->substr(0, comment);
    text = text.substr(0, text.find_last_not_of(blanks) + 1);
    const bool goes_on = !commented && text.ends_with('\\');
    if (!goes_on && joined_.empty()) return text;
    joined_ += goes_on ? text.substr(0, text.size() - 1) : text;
    if (!goes_on) return joined_;
    joined_ += ' ';
  }
  if (first == 0) return std::nullopt;
  return joined_;
}

std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

std::optional<double> real_number(std::string_view word) {
  double value = 0;
  const auto [end, error] = read_whole(word, value);
  if (error == std::errc::result_out_of_range) {
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    const double size = tiny ? 0 : std::numeric_limits<double>::infinity();
    return word.starts_with('-') ? -size : size;
  }
  if (error != std::errc()) return written_on_windows(word);
  return value;
}

std::optional<long long> whole_number(std::string_view word) {
  long long value = 0;
  const auto [end, error] = read_whole(word, value);
  if (error != std::errc()) return std::nullopt;
  return value;
}

}  // namespace burin
