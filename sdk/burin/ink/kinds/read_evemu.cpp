// Reads EVEMU recordings of tablets: lines "A: axis min max fuzz flat resolution" that describe the device,
// and "E: time type code value". Old recordings lack the description; it is then in a .desc file beside them
// whose name the recording's begins with.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/ink/decode/evdev_frames.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/text_window.h>
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace burin {
namespace {

namespace fs = std::filesystem;

/// "sec.usec", whole microseconds apart, so that wall-clock times keep them.
double parse_time(std::string_view word) {
  double time = 0;
  if (!take_number(word, time) || !word.empty()) throw Error("expected a time, seconds");
  return time;
}

EvdevEvent parse_event(std::string_view rest) {
  EvdevEvent event;
  event.time = parse_time(take_word(rest));
  if (!read_whole(take_word(rest), event.type, 16) || !read_whole(take_word(rest), event.code, 16) ||
      !read_whole(take_word(rest), event.value))
    throw Error("expected an event: time type code value");
  return event;
}

void parse_axis(std::string_view rest, EvdevAxes& axes) {
  unsigned code = 0;
  int least = 0, most = 0, fuzz = 0, flat = 0, resolution = 0;
  if (!read_whole(take_word(rest), code, 16) || !read_whole(take_word(rest), least) ||
      !read_whole(take_word(rest), most) || !read_whole(take_word(rest), fuzz) ||
      !read_whole(take_word(rest), flat))
    throw Error("expected an axis: code min max fuzz flat resolution");
  read_whole(take_word(rest), resolution);  // since version 1.2 of the format
  axes[code] = {static_cast<double>(least), static_cast<double>(most), static_cast<double>(resolution)};
}

/// What the lines before the events tell of the device.
struct Description {
  std::string device;
  EvdevAxes axes;
};

/// Calls `take` with each event; lines of the description go to `description` before.
template <class Take>
void parse(const PenFileText& file, Description& description, const Take& take) {
  for_each_line_of(file, [&](std::string_view line) {
    const std::string_view before = line.substr(0, line.find('#'));
    if (line.starts_with("N:")) {
      line.remove_prefix(2);
      skip_blanks(line);
      description.device = line.substr(0, line.find_last_not_of(blanks) + 1);
    } else if (line.starts_with("A:")) {
      parse_axis(before.substr(2), description.axes);
    } else if (line.starts_with("E:")) {
      take(parse_event(before.substr(2)));
    }
  });
}

/// The description with the longest name that the recording's begins with, or an empty path.
fs::path description_beside(const fs::path& recording) {
  fs::path best;
  std::error_code error;
  const std::string stem = recording.stem().string();
  for (const fs::directory_entry& entry : fs::directory_iterator(recording.parent_path(), error)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".desc" || !stem.starts_with(path.stem().string())) continue;
    if (path.stem().string().size() > best.stem().string().size()) best = path;
  }
  return best;
}

void take_description_beside(const fs::path& recording, Description& description) {
  const fs::path path = description_beside(fs::absolute(recording));
  if (!path.empty()) parse({path, read_file(path)}, description, [](const EvdevEvent&) {});
}

}  // namespace

bool is_evemu(std::string_view text) {
  if (text.starts_with("# EVEMU")) return true;
  // Before version 1.2 of the format there was no such line, and hid-recorder has lines like these too.
  if (!text.starts_with("E: ") && !text.starts_with("N: ")) return false;
  const std::string_view line = text.substr(0, text.find('\n'));
  if (line.starts_with("N:")) return text.find("\nA: ") != text.npos;
  try {
    parse_event(line.substr(2, line.find('#') - 2));
    return true;
  } catch (const Error&) {
    return false;
  }
}

PenFile read_evemu(const PenFileText& file) {
  Description description;
  std::optional<EvdevFrames> frames;
  parse(file, description, [&](const EvdevEvent& event) {
    if (!frames && description.axes.empty()) take_description_beside(file.path, description);
    if (!frames) frames.emplace(description.axes);
    frames->take(event);
  });
  PenFile content = frames ? frames->finish() : PenFile();
  content.device = description.device;
  return content;
}

}  // namespace burin
