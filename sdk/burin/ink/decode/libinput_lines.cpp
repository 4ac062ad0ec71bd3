#include <burin/ink/decode/libinput_lines.h>
#include <burin/ink/parse/scan.h>
#include <fmt/format.h>

#include <algorithm>
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

/// The last line of a text that ends with a line break, or nothing.
std::string_view last_line(std::string_view text) {
  text = text.substr(0, text.empty() ? 0 : text.size() - 1);
  return text.substr(text.rfind('\n') + 1);
}

/// Whether a run of events below the line `above` goes on after this line, before `rest`: where another frame
/// begins, which has a list of events of its own.
bool goes_on(std::string_view line, std::string_view above, std::string_view rest) {
  std::string_view item = line;
  return line == above && take_character(item, '-') && take_word(item) == "evdev:" && item.empty() &&
         libinput_event(take_line(rest)).has_value();
}

/// Calls `take` with each line that a parser of YAML is to see and its number, from 0; and with the byte at
/// which the line begins if it stands for a run of events.
template <class Take>
void for_each_line_but_runs(std::string_view text, const Take& take) {
  std::string_view above;
  bool in_run = false;
  std::size_t number = 0;
  for (std::string_view rest = text; !rest.empty(); ++number) {
    const std::size_t at = text.size() - rest.size();
    const std::string_view line = take_line(rest);
    const bool event = libinput_event(line).has_value();
    if (event && !in_run) take(line, number, std::optional(at));
    in_run = event || (in_run && goes_on(line, above, rest));
    if (in_run) continue;
    take(line, number, std::optional<std::size_t>());
    above = line;
  }
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
  for_each_line_but_runs(text, [&](std::string_view line, std::size_t, std::optional<std::size_t> run) {
    if (run)
      fmt::format_to(std::back_inserter(made), "{}- {}{}\n", line.substr(0, line.find('-')), run_mark, *run);
    else
      made.append(line) += '\n';
  });
  return made;
}

std::size_t line_without_runs(std::string_view text, std::size_t line) {
  // A fault at the end of the text is on the line after the last.
  auto found = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  std::size_t passed = 0;
  for_each_line_but_runs(text, [&](std::string_view, std::size_t number, std::optional<std::size_t>) {
    if (passed++ == line) found = number;
  });
  return found;
}

bool for_each_event_of_run(std::string_view text, std::string_view item,
                           const std::function<void(const EvdevEvent& event)>& take) {
  std::size_t at = 0;
  if (!item.starts_with(run_mark) || !read_whole(item.substr(run_mark.size()), at) || at >= text.size())
    return false;
  const std::string_view above = last_line(text.substr(0, at));
  text.remove_prefix(at);
  bool any = false;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (const auto event = libinput_event(line)) {
      take(*event);
      any = true;
    } else if (!any || !goes_on(line, above, text)) {
      break;
    }
  }
  return any;
}

}  // namespace burin
