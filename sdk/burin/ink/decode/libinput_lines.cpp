#include <burin/ink/decode/libinput_lines.h>
#include <burin/ink/parse/scan.h>
#include <fmt/format.h>

#include <array>
#include <iterator>

namespace burin {
namespace {

constexpr std::string_view run_mark = "run:";

/// Removes the next line from the front of a text.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

}  // namespace

std::optional<EvdevEvent> libinput_event(std::string_view line) {
  if (!take_character(line, '-') || !line.starts_with(' ') || !take_character(line, '[')) return std::nullopt;
  std::array<int, 5> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && !take_character(line, ',')) return std::nullopt;
    skip_blanks(line);
    if (!take_whole(line, numbers[i])) return std::nullopt;
  }
  const auto [seconds, microseconds, type, code, value] = numbers;
  if (!take_character(line, ']') || seconds < 0 || microseconds < 0 || type < 0 || code < 0)
    return std::nullopt;
  skip_blanks(line);
  if (!line.empty() && line.front() != '#') return std::nullopt;
  return EvdevEvent{seconds + microseconds / 1e6, static_cast<unsigned>(type), static_cast<unsigned>(code),
                    value};
}

std::string with_runs_of_events(std::string_view text) {
  std::string made;
  bool in_run = false;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t at = text.size() - rest.size();
    const std::string_view line = take_line(rest);
    const bool event = libinput_event(line).has_value();
    if (!event) made += line;
    if (event && !in_run)
      fmt::format_to(std::back_inserter(made), "{}- {}{}", line.substr(0, line.find('-')), run_mark, at);
    in_run = event;
    made += '\n';
  }
  return made;
}

bool for_each_event_of_run(std::string_view text, std::string_view item,
                           const std::function<void(const EvdevEvent& event)>& take) {
  std::size_t at = 0;
  if (!item.starts_with(run_mark) || !read_whole(item.substr(run_mark.size()), at) || at >= text.size())
    return false;
  text.remove_prefix(at);
  auto event = libinput_event(take_line(text));
  if (!event) return false;
  for (; event; event = libinput_event(take_line(text))) take(*event);
  return true;
}

}  // namespace burin
