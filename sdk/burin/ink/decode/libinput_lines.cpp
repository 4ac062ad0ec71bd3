#include <burin/ink/decode/libinput_lines.h>
#include <burin/ink/parse/scan.h>
#include <fmt/format.h>

#include <array>
#include <utility>

namespace burin {
namespace {

constexpr std::string_view run_mark = "run:";

/// Whether a run of events below the line `above` goes on after this line, before `next`: where another frame
/// begins, which has a list of events of its own.
bool goes_on(std::string_view line, std::string_view above, std::string_view next) {
  std::string_view item = line;
  return line == above && take_character(item, '-') && take_word(item) == "evdev:" && item.empty() &&
         libinput_event(next).has_value();
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

bool LibinputLines::next(std::string& line) {
  while (!text_.text().empty() || text_.grow()) {
    const std::uintmax_t at = text_.place();
    const std::string_view found = text_.take_line();
    ++number_;
    if (libinput_event(found)) {
      if (std::exchange(in_run_, true)) continue;
      line = fmt::format("{}- {}{}:{}", found.substr(0, found.find('-')), run_mark, above_at_, at);
      return true;
    }
    line = found;
    in_run_ = in_run_ && goes_on(line, above_, text_.line());
    if (in_run_) continue;
    above_ = line;
    above_at_ = at;
    return true;
  }
  return false;
}

bool for_each_event_of_run(TextWindow& text, std::string_view item,
                           const std::function<void(const EvdevEvent& event)>& take) {
  std::uintmax_t above_at = 0, first = 0;
  if (!item.starts_with(run_mark)) return false;
  item.remove_prefix(run_mark.size());
  if (!take_whole(item, above_at) || !take_character(item, ':') || !read_whole(item, first)) return false;
  // An item that the recording itself has must not have its events taken again and again.
  if (above_at < text.place()) return false;
  text.go_to(above_at);
  const std::string above(text.take_line());
  if (text.place() != first) return false;
  bool any = false;
  while (!text.text().empty() || text.grow()) {
    const std::string_view line = text.line();
    if (const auto event = libinput_event(line)) {
      take(*event);
      any = true;
      text.take_line();
      continue;
    }
    if (!any || line != above) break;
    text.take_line();
    if (!goes_on(above, above, text.line())) break;
  }
  return any;
}

}  // namespace burin
