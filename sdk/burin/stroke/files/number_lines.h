#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace burin {

/// Fills `numbers` with those of the line, between blanks. Throws Error unless there are exactly as many;
/// `expected` names them: "four numbers: time x y pressure".
void parse_numbers(std::string_view line, std::string_view expected, std::span<double> numbers);

/// Calls `take` with every line of a text file, less its newline, and the line's number from 1. What it
/// throws as an Error becomes a FileError that names the line. Throws FileError for a file that cannot be
/// read.
void for_each_line(const std::filesystem::path& path,
                   const std::function<void(std::string_view line, std::size_t number)>& take);

}  // namespace burin
