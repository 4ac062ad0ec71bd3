#include "markdown.h"

#include <iterator>
#include <regex>
#include <sstream>

namespace burin::test {

namespace {

constexpr std::string_view fence = "```";

bool is_fence(const std::string& line) { return line.starts_with(fence); }

}  // namespace

std::vector<std::string> lines_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fenced_blocks(std::string_view markdown, std::string_view language) {
  std::vector<std::string> blocks;
  bool inside = false, wanted = false;
  for (const std::string& line : lines_of(markdown)) {
    if (is_fence(line)) {
      inside = !inside;
      wanted = inside && line.substr(fence.size()) == language;
      if (wanted) blocks.emplace_back();
    } else if (wanted) {
      blocks.back() += line + '\n';
    }
  }
  return blocks;
}

std::vector<std::string> link_targets(std::string_view markdown) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  std::vector<std::string> targets;
  bool inside = false;
  for (const std::string& line : lines_of(markdown)) {
    if (is_fence(line)) inside = !inside;
    if (inside) continue;
    for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match)
      targets.push_back((*match)[1]);
  }
  return targets;
}

}  // namespace burin::test
