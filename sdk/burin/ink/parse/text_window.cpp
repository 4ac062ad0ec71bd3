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
  const std::size_t kept = text_.size(), asked = std::max(file_->pieces.block, kept);
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

bool TextWindow::skip_blanks_and_grow() {
  do {
    std::string_view rest = text_;
    burin::skip_blanks(rest);
    remove_prefix(text_.size() - rest.size());
  } while (text_.empty() && grow());
  return !text_.empty();
}

std::string_view TextWindow::line() {
  const auto end_from = [this](std::size_t from) {
    const auto is_end = [](char c) { return c == '\n' || c == '\r'; };
    return static_cast<std::size_t>(
        std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(from), text_.end(), is_end) - text_.begin());
  };
  std::size_t end = end_from(0);
  for (std::size_t searched = text_.size(); end == searched && grow(); searched = text_.size())
    end = end_from(searched);
  // A newline that follows a carriage return belongs to it.
  if (end + 1 == text_.size() && text_[end] == '\r') grow();
  return text_.substr(0, end);
}

std::string_view TextWindow::take_line() {
  const std::string_view line = this->line(), rest = text_.substr(line.size());
  const std::size_t end = rest.starts_with("\r\n") ? 2 : 1;
  remove_prefix(std::min(line.size() + end, text_.size()));
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
