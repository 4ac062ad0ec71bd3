// Reads times as ISO 8601 and XML Schema write them.
#include <burin/ink/parse/iso_time.h>
#include <burin/ink/parse/scan.h>

#include <chrono>

namespace burin {
namespace {

/// Removes a number of this many digits from the front of a text.
bool take_digits(std::string_view& text, std::size_t digits, int& number) {
  std::string_view word = text.substr(0, digits);
  unsigned value = 0;
  if (word.size() < digits || !read_whole(word, value)) return false;
  text.remove_prefix(digits);
  number = static_cast<int>(value);
  return true;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text.front()) == any_of.npos) return false;
  text.remove_prefix(1);
  return true;
}

/// The seconds of a day, "10:20" or "10:20:30.5".
std::optional<double> take_clock(std::string_view& text) {
  int hours = 0, minutes = 0;
  if (!take_digits(text, 2, hours) || !take(text, ":") || !take_digits(text, 2, minutes)) return std::nullopt;
  double seconds = 0;
  if (take(text, ":") && !take_number(text, seconds)) return std::nullopt;
  return 3600 * hours + 60 * minutes + seconds;
}

/// The seconds that a zone is ahead, "Z", "+01:00", "-0530" or nothing.
std::optional<double> zone_of(std::string_view text) {
  if (text.empty() || text == "Z") return 0;
  const double sign = text.front() == '-' ? -1 : 1;
  int hours = 0, minutes = 0;
  if (!take(text, "+-") || !take_digits(text, 2, hours)) return std::nullopt;
  take(text, ":");
  if (!text.empty() && !take_digits(text, 2, minutes)) return std::nullopt;
  return text.empty() ? std::optional(sign * (3600 * hours + 60 * minutes)) : std::nullopt;
}

}  // namespace

std::optional<double> iso_time(std::string_view text) {
  int year = 0, month = 0, day = 0;
  if (!take_digits(text, 4, year) || !take(text, "-") || !take_digits(text, 2, month) || !take(text, "-") ||
      !take_digits(text, 2, day) || !take(text, "T "))
    return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  const auto clock = take_clock(text);
  const auto zone = clock ? zone_of(text) : std::nullopt;
  if (!zone || !date.ok()) return std::nullopt;
  const auto days = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
  return 86400 * days + *clock - *zone;
}

}  // namespace burin
