#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The lines of a text as programs on any system write them: CR, LF or CRLF ends a line, all of them in one
/// file too, and a UTF-8 byte order mark at the beginning is not part of the text.
class TextLines {
 public:
  /// `text` must outlive this and what it gives.
  explicit TextLines(std::string_view text);

  /// The next line without its end; nothing at the end of the text. A line end at the very end of the text
  /// begins no further line.
  std::optional<std::string_view> next();

  /// The next line without its comment, which begins at a '#' anywhere, and joined by a blank to the next one
  /// where a '\' stands at its end: not one that belongs to the comment. Valid until the next call.
  std::optional<std::string_view> next_joined();

  /// Number of the line given last, from 1; of joined lines the first one's.
  std::size_t number() const { return number_; }

  /// Bytes of the text that lie behind what was given.
  std::size_t offset() const { return at_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t number_ = 0, last_ = 0;  ///< of the lines given and read last
  std::string joined_;
};

/// Cuts the next word off the front of a line: what stands between blanks and tabs. Empty at its end.
std::string_view next_word(std::string_view& line);

/// The number that a word is as a whole, with or without a sign; infinite beyond the range of doubles.
/// Nothing for anything else.
std::optional<double> real_number(std::string_view word);
std::optional<long long> whole_number(std::string_view word);

}  // namespace burin
