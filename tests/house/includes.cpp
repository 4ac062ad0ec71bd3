#include "includes.h"

#include <fstream>
#include <regex>

namespace burin::test {
namespace fs = std::filesystem;

namespace {

/// Sources of the command name its headers from its folder on, all others from where they are themselves.
fs::path own_file(const fs::path& repository, const fs::path& file, const std::string& target, bool quoted) {
  if (target.starts_with("burin/")) return "sdk" / fs::path(target);
  if (!quoted) return {};
  fs::path beside = (file.parent_path() / target).lexically_normal();
  const bool of_command = house_folder(file) == "host_stub" && !fs::exists(repository / beside);
  return of_command ? "host_stub" / fs::path(target) : beside;
}

void read_includes(const fs::path& repository, const fs::path& file, std::vector<Include>& includes) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::ifstream in(repository / file);
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    std::smatch match;
    if (!std::regex_match(text, match, pattern)) continue;
    includes.push_back({file, line, match[2], own_file(repository, file, match[2], match[1] == "\"")});
  }
}

}  // namespace

std::vector<Include> all_includes(const fs::path& repository) {
  std::vector<Include> includes;
  for (const char* root : {"sdk/burin", "brushes", "brush_process", "host_probe", "host_stub"}) {
    if (!fs::exists(repository / root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(repository / root)) {
      if (is_source(entry.path()))
        read_includes(repository, fs::relative(entry.path(), repository), includes);
    }
  }
  return includes;
}

std::string at(const Include& include) {
  return include.file.generic_string() + ":" + std::to_string(include.line);
}

bool is_source(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".h" || extension == ".cpp" || extension == ".c" || extension == ".hpp";
}

std::string house_folder(const fs::path& file) {
  const std::string path = room(file);
  return path.substr(0, path.find('/'));
}

std::string room(const fs::path& file) {
  const fs::path folder = file.parent_path();
  const bool of_sdk = folder.begin() != folder.end() && *folder.begin() == "sdk";
  return (of_sdk ? folder.lexically_relative("sdk/burin") : folder).generic_string();
}

}  // namespace burin::test
