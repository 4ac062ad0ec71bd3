#include <burin/surface/formats/off_words.h>

namespace burin {
namespace {

bool has_words(std::string_view line) { return !next_word(line).empty(); }

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

}  // namespace

OffWords::OffWords(std::string_view text) : lines_(text) {
  TextLines all(text);
  while (const auto line = all.next())
    if (has_words(without_comment(*line))) ++lines_left_;
}

bool OffWords::go_on() {
  while (!has_words(line_)) {
    const auto line = lines_.next();
    if (!line) return false;
    line_ = without_comment(*line);
    if (has_words(line_)) --lines_left_;
  }
  return true;
}

std::string_view OffWords::next() {
  go_on();
  return next_of_line();
}

std::size_t OffWords::left_of_line() const {
  std::size_t count = 0;
  for (std::string_view rest = line_; !next_word(rest).empty();) ++count;
  return count;
}

}  // namespace burin
