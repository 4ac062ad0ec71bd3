#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace burin::test {

/// The insides of all blocks fenced as ```LANGUAGE, each line with its newline.
std::vector<std::string> fenced_blocks(std::string_view markdown, std::string_view language);

/// The targets of links and pictures, `](TARGET)`, in the text outside of fences.
std::vector<std::string> link_targets(std::string_view markdown);

std::vector<std::string> lines_of(std::string_view text);

}  // namespace burin::test
