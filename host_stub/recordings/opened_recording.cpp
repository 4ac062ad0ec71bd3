// Tells .stroke files from pen files by their first bytes, and reads either.
#include "recordings/opened_recording.h"

#include <burin/ink/pen_strokes.h>
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string_view>

#include "system/console.h"

namespace burin::command {
namespace {

/// Where the header of a `.stroke` file names it.
constexpr std::size_t head_bytes = 80;

bool begins_as_strokes(std::string_view text) {
  return text.substr(0, head_bytes).find("\"burin_stroke\"") != text.npos;
}

/// The first bytes of a regular file; none of a pipe, which can be read only once.
std::string head_of(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return {};
  std::string head(head_bytes, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

OpenedRecording opened(Recording strokes) {
  PenFile file = pen_file_of(strokes);
  return {std::move(file), std::move(strokes)};
}

}  // namespace

OpenedRecording open_recording(const std::string& path) {
  if (begins_as_strokes(head_of(path))) return opened(read_strokes(path));
  const PenFileText text = open_pen_file(path);
  if (begins_as_strokes(text.text)) return opened(read_strokes(path, text.text));
  return {read_pen_file(text), {}};
}

void warn_if_cut_off(const std::string& path, std::optional<std::size_t> line) {
  if (line) warn(fmt::format("{}:{}: the recording was cut off here", path, *line));
}

}  // namespace burin::command
