#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stroke/import.h>
#include <burin/stroke/pen_events.h>
#include <burin/stroke/recording_faults.h>

#include <array>
#include <charconv>
#include <string_view>

namespace burin {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Takes the next number off the text; throws Error where there is none.
double take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  const bool at_end = text.empty() || blanks.find(text.front()) != blanks.npos;
  if (error != std::errc() || !at_end) throw Error("expected four numbers: time x y pressure");
  return value;
}

PenEvent parse_event(std::string_view line) {
  std::array<double, 4> numbers{};
  for (double& number : numbers) number = take_number(line);
  if (line.find_first_not_of(blanks) != line.npos) throw Error("expected four numbers, found more");
  PenEvent event;
  event.sample.time = numbers[0];
  event.sample.position = {numbers[1], numbers[2], 0};
  event.sample.pen.pressure = static_cast<float>(numbers[3]);
  event.contact = numbers[3] > 0;
  if (const std::string_view fault = fault_of(event.sample); !fault.empty()) throw Error(std::string(fault));
  return event;
}

}  // namespace

Recording import_mypaint_events(const std::filesystem::path& path, const Camera& camera) {
  const std::string text = read_file(path);
  std::vector<PenEvent> events;
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++line;
    try {
      events.push_back(parse_event(std::string_view(text).substr(begin, end - begin)));
    } catch (const Error& error) {
      throw FileError(path.string(), std::to_string(line), error.what());
    }
    begin = end;
  }
  Recording recording = recording_of(events, {.time = true, .pressure = true}, camera);
  if (recording.strokes.empty()) throw FileError(path.string(), "holds no stroke");
  return recording;
}

}  // namespace burin
