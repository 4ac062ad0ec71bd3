#pragma once
#include <burin/base/error.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

namespace burin {

/// The text of a pen file from a place on, of which only a window is in memory: as much of the file as its
/// user has asked for and not yet removed.
class TextWindow {
 public:
  /// A text in memory, which must outlive the window.
  explicit TextWindow(std::string_view text) : whole_(text), text_(text) {}

  /// The text of a file, which must outlive the window. Throws FileError if it cannot be read.
  explicit TextWindow(const PenFileText& file);

  TextWindow(const TextWindow&) = delete;
  TextWindow& operator=(const TextWindow&) = delete;

  std::string_view text() const { return text_; }
  std::uintmax_t place() const { return place_; }  ///< the byte of the text at which the window begins

  /// Lets the window begin at another byte of the text. Reads nothing again if that lies in the last block.
  void go_to(std::uintmax_t place);

  void remove_prefix(std::size_t count) {
    text_.remove_prefix(count);
    place_ += count;
  }

  /// Appends more of the text to the window, at least as much as it has. Views of it are then no longer
  /// valid. Returns false at the end. Throws FileError where the window would have more than 60 MB.
  bool grow();

  /// Whether a character that is no blank follows; removes the blanks before it.
  bool skip_blanks() {
    if (!text_.empty() && !is_blank(text_.front())) return true;
    return skip_blanks_and_grow();
  }

  /// Removes blanks and then this character. Returns false if another one follows.
  bool take_character(char expected) {
    if (!skip_blanks() || text_.front() != expected) return false;
    remove_prefix(1);
    return true;
  }

  /// The next line without its end, which is LF, CR or CRLF. Empty at the end of the text.
  std::string_view line();

  /// Removes the next line and its end; returns the line.
  std::string_view take_line();

 private:
  bool skip_blanks_and_grow();

  std::string_view whole_;  ///< of a text in memory
  std::string_view text_;
  std::uintmax_t place_ = 0;
  const PenFileText* file_ = nullptr;  ///< that `in_` reads
  std::unique_ptr<std::ifstream> in_;
  std::string buffer_;
};

/// Calls `take` with every line of a pen file, without its end. An Error that it throws becomes a FileError
/// that names the line.
template <class Take>
void for_each_line_of(const PenFileText& file, const Take& take) {
  std::size_t number = 0;
  for (TextWindow text(file); !text.text().empty() || text.grow();) {
    ++number;
    try {
      take(text.take_line());
    } catch (const FileError&) {
      throw;
    } catch (const Error& error) {
      throw FileError(file.path.string(), std::to_string(number), error.what());
    }
  }
}

/// The line, from 1, of a byte of the text.
std::size_t line_of(const PenFileText& file, std::uintmax_t place);

}  // namespace burin
