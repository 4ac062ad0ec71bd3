#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace burin::test {

/// The insides of all blocks fenced as ```LANGUAGE, each line with its newline.
std::vector<std::string> fenced_blocks(std::string_view markdown, std::string_view language);

/// Where links and pictures of the text outside fences point to, `](TARGET)`.
std::vector<std::string> link_targets(std::string_view markdown);

std::vector<std::string> lines_of(std::string_view text);

}  // namespace burin::test
