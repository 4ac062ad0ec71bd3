#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace burin {

/// The finite number that a text is, if it is one.
std::optional<double> parse_number(std::string_view text);

/// All numbers between commas, or nothing when one of them is none.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

}  // namespace burin
