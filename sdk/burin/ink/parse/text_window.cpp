// Reads a file block by block, as far as it is asked for.
#include <burin/base/error.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/text_window.h>
#include <burin/ink/parse/unpack.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace burin {

TextWindow::TextWindow(const PenFileText& file) : whole_(file.text), text_(file.text) {
  if (file.rest_at == 0) return;
  file_ = &file;
  text_ = {};
  in_ = std::make_unique<std::ifstream>(file.path, std::ios::binary);
  go_to(0);
}

void TextWindow::go_to(std::uintmax_t place) {
  const std::uintmax_t end = place_ + text_.size(), begin = end - buffer_.size();
  place_ = place;
  if (!file_) {
    text_ = whole_.substr(std::min<std::uintmax_t>(place, whole_.size()));
  } else if (!buffer_.empty() && place >= begin && place <= end) {
    text_ = std::string_view(buffer_).substr(place - begin);
  } else {
    in_->clear();
    in_->seekg(static_cast<std::streamoff>(file_->rest_at - file_->text.size() + place));
    if (!*in_) throw FileError(file_->path.string(), std::strerror(errno));
    buffer_.clear();
    text_ = {};
  }
}

bool TextWindow::grow() {
  if (!file_) return false;
  constexpr std::size_t block_bytes = std::size_t{1} << 18;
  const std::size_t kept = text_.size(), asked = std::max(block_bytes, kept);
  if (kept + asked > most_parsed_bytes)
    throw FileError(file_->path.string(), "a line, or a part of JSON, that is longer than 30 MB");
  buffer_.erase(0, buffer_.size() - kept);
  buffer_.resize(kept + asked);
  in_->read(buffer_.data() + kept, static_cast<std::streamsize>(asked));
  buffer_.resize(kept + static_cast<std::size_t>(in_->gcount()));
  if (in_->bad()) throw FileError(file_->path.string(), "reading failed");
  text_ = buffer_;
  return text_.size() > kept;
}

bool TextWindow::skip_blanks() {
  do {
    std::string_view rest = text_;
    burin::skip_blanks(rest);
    remove_prefix(text_.size() - rest.size());
  } while (text_.empty() && grow());
  return !text_.empty();
}

bool TextWindow::take_character(char expected) {
  if (!skip_blanks() || text_.front() != expected) return false;
  remove_prefix(1);
  return true;
}

std::string_view TextWindow::line(char end) {
  std::size_t at = text_.find(end);
  for (std::size_t searched = text_.size(); at == text_.npos && grow(); searched = text_.size())
    at = text_.find(end, searched);
  return text_.substr(0, at);
}

std::string_view TextWindow::take_line(char end) {
  const std::string_view line = this->line(end);
  remove_prefix(std::min(line.size() + 1, text_.size()));
  return line;
}

std::size_t line_of(const PenFileText& file, std::uintmax_t place) {
  std::size_t line = 1;
  for (TextWindow text(file); !text.text().empty() || text.grow();) {
    const auto before = std::min<std::uintmax_t>(place - text.place(), text.text().size());
    const std::string_view passed = text.text().substr(0, before);
    line += static_cast<std::size_t>(std::ranges::count(passed, '\n'));
    if (before < text.text().size()) break;
    text.remove_prefix(before);
  }
  return line;
}

}  // namespace burin
