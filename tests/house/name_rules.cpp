// Looks for names by lines, as clang-format lays them out: what a namespace holds begins in the first column.
#include "name_rules.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>

namespace burin::test {
namespace fs = std::filesystem;

namespace {

/// The name that a line in a namespace defines: of functions with their parameters, of aliases with the type.
std::optional<std::string> defined_name(const std::string& line) {
  static const std::regex type(R"((?:struct|class|enum class|enum) (\w+)(?: [:{]| final).*)");
  static const std::regex alias(R"(using (\w+ = .*);)");
  static const std::regex constant(R"((?:constexpr|const) [^(=]*?(\w+)(?:\[\w*\])*(?: =|\{|;).*)");
  static const std::regex function(R"((?!template|return)[A-Za-z_][\w:<>,&* ]* [&*]?(\w+)\(([^;()]*)\).*)");
  static const std::regex parameter_name(R"( \w+(?=,|$))");
  std::smatch found;
  for (const std::regex* form : {&type, &alias, &constant})
    if (std::regex_match(line, found, *form)) return found[1];
  if (line.starts_with("TEST") || line.starts_with("INSTANTIATE") || line.starts_with("using "))
    return std::nullopt;
  if (!std::regex_match(line, found, function)) return std::nullopt;
  return found.str(1) + "(" + std::regex_replace(found.str(2), parameter_name, "") + ")";
}

std::set<std::string> hidden_names(const fs::path& source) {
  std::set<std::string> names;
  bool hidden = false;
  std::ifstream in(source);
  for (std::string line; std::getline(in, line);) {
    if (line == "namespace {") hidden = true;
    if (line.starts_with("}  // namespace")) hidden = false;
    if (!hidden || line.empty() || !(std::isalpha(static_cast<unsigned char>(line.front())))) continue;
    if (const auto name = defined_name(line)) names.insert(*name);
  }
  return names;
}

/// An alias is repeated if it stands for several types.
std::string key_of(const std::string& name) { return name.substr(0, name.find(" = ")); }

}  // namespace

std::vector<std::string> repeated_names(const fs::path& repository) {
  std::map<std::string, std::map<std::string, std::map<std::string, std::string>>>
      sources;  // by room, key, file
  for (const char* folder :
       {"sdk", "host_stub", "host_probe", "brush_process", "samples/generate", "tests"}) {
    if (!fs::exists(repository / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(repository / folder)) {
      const std::string room = entry.path().parent_path().lexically_relative(repository).generic_string();
      if (entry.path().extension() != ".cpp" || room.find("bad_plugins") != room.npos ||
          room.ends_with("/modules"))
        continue;
      for (const std::string& name : hidden_names(entry.path()))
        sources[room][key_of(name)][entry.path().filename().string()] = name;
    }
  }
  std::vector<std::string> repeated;
  for (const auto& [room, names] : sources)
    for (const auto& [key, files] : names) {
      const bool same_alias =
          files.begin()->second != key &&
          std::ranges::all_of(files, [&](const auto& file) { return file.second == files.begin()->second; });
      if (files.size() < 2 || same_alias) continue;
      std::string told = room + ": " + key + ":";
      for (const auto& [file, name] : files) told += " " + file;
      repeated.push_back(told);
    }
  return repeated;
}

}  // namespace burin::test
