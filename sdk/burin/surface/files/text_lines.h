#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Splits a text into lines. CR, LF or CRLF ends a line, also mixed in one file, and a UTF-8 byte order mark
/// at the start is skipped.
class TextLines {
 public:
  /// `text` must outlive the object and the lines.
  explicit TextLines(std::string_view text);

  /// The next line without its line end; nothing at the end of the text. A line end at the very end of the
  /// text does not start another line.
  std::optional<std::string_view> next();

  /// The next line without its comment, which starts at any '#' but in numbers as "1.#INF". A line that ends
  /// with '\' outside of a comment is joined with the next one by a blank. Valid until the next call.
  std::optional<std::string_view> next_joined();

  /// The number of the last returned line, counted from 1; for joined lines that of the first.
  std::size_t number() const { return number_; }

  /// The offset in the text, bytes, after the last returned line and its line end.
  std::size_t offset() const { return at_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t number_ = 0, last_ = 0;  ///< numbers of the lines last returned and last read
  std::string joined_;
};

/// Removes the next word, delimited by white space, from the front of a line. Empty at the end of the line.
std::string_view next_word(std::string_view& line);

/// Parse a whole word as a number with an optional sign. A real number beyond the range of doubles is
/// infinite, one too small is 0; "nan", "inf" and the like of Windows ("-1.#IND") are not finite. Return
/// nothing if the word is not a number, or not in the range of long long.
std::optional<double> real_number(std::string_view word);
std::optional<long long> whole_number(std::string_view word);

}  // namespace burin
