#pragma once
#include <burin/surface/files/text_lines.h>

#include <cstddef>
#include <string_view>

namespace burin {

/// The words of an OFF file. White space of any kind separates them, and '#' begins a comment that ends with
/// its line.
class OffWords {
 public:
  /// `text` must outlive the object and the words. Reads it once to count its lines.
  explicit OffWords(std::string_view text);

  /// Removes and returns the next word, of this line or of one that follows; empty at the end of the text.
  std::string_view next();

  /// The same, but empty at the end of the line.
  std::string_view next_of_line() { return next_word(line_); }

  /// Goes to the next line that has words if this one has none left. Returns false at the end of the text.
  bool go_on();

  /// Returns the number of words that are left of the line.
  std::size_t left_of_line() const;

  void skip_line() { line_ = {}; }

  /// The number of lines with words after this one.
  std::size_t lines_left() const { return lines_left_; }

  /// The number of the line, from 1.
  std::size_t line_number() const { return lines_.number(); }

 private:
  TextLines lines_;
  std::string_view line_;  ///< what is left of the line
  std::size_t lines_left_ = 0;
};

}  // namespace burin
