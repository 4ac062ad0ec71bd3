// Reads lines of numbers.
#include <burin/base/error.h>
#include <burin/stroke/files/number_lines.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

namespace burin {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Removes the next number from the front of the text. Returns false if there is none.
bool take_number(std::string_view& text, double& value) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  const bool at_end = text.empty() || blanks.find(text.front()) != blanks.npos;
  return error == std::errc() && at_end;
}

}  // namespace

void parse_numbers(std::string_view line, std::string_view expected, std::span<double> numbers) {
  for (double& number : numbers)
    if (!take_number(line, number)) throw Error(fmt::format("expected {}", expected));
  if (line.find_first_not_of(blanks) != line.npos)
    throw Error(fmt::format("expected {}, found more", expected.substr(0, expected.find(':'))));
}

}  // namespace burin
