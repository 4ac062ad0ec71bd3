#pragma once
#include <span>
#include <string_view>

namespace burin {

/// Reads the numbers of a line, separated by blanks, into `numbers`. Throws Error unless the line has exactly
/// as many; `expected` describes them in the message: "four numbers: time x y pressure".
void parse_numbers(std::string_view line, std::string_view expected, std::span<double> numbers);

}  // namespace burin
