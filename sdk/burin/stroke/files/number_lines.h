#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace burin {

/// Reads the numbers of a line, separated by blanks, into `numbers`. Throws Error unless the line has exactly
/// as many; `expected` describes them in the message: "four numbers: time x y pressure".
void parse_numbers(std::string_view line, std::string_view expected, std::span<double> numbers);

/// Calls `take` with every line of a text, without its newline, and the line's number from 1. An Error thrown
/// by `take` becomes a FileError that names the line of `path`.
void for_each_line(const std::string& text, const std::filesystem::path& path,
                   const std::function<void(std::string_view line, std::size_t number)>& take);

}  // namespace burin
