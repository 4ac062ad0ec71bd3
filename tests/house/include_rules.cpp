#include "include_rules.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

namespace burin::test {
namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

/// The house: what a folder may include. Data flows down the list, includes point up; who may include a
/// folder may include what that folder includes.
const std::map<std::string, Names> may_include = {
    {"abi", {}},
    {"math", {}},
    {"plugin", {"abi", "math"}},
    {"base", {"math"}},
    {"surface", {"base"}},
    {"subdiv", {"surface"}},
    {"stroke", {"surface"}},
    {"chart", {"stroke"}},
    {"stamp", {"base"}},
    {"deform", {"abi", "chart"}},
    {"feature", {"chart"}},
    {"refine", {"chart"}},
    {"volume", {"chart"}},
    {"host",
     {"abi", "math", "plugin", "base", "surface", "stroke", "chart", "deform", "feature", "refine",
      "volume"}},
    {"services", {"host", "stamp"}},
    {"brushes", {"abi", "math", "plugin"}},
    {"host_stub", {"services", "subdiv"}},
};

/// Third-party headers, by how they begin, and the folders that may see them.
const std::map<std::string, Names> third_party = {
    {"opensubdiv/", {"subdiv"}},
    {"openvdb/", {"volume"}},
    {"OpenImageIO/", {"stamp"}},
    {"freetype/", {"stamp"}},
    {"harfbuzz/", {"stamp"}},
    {"embree", {"surface"}},
    {"nanoflann", {"surface"}},
    {"tbb/", {"base", "surface"}},
    {"oneapi/tbb", {"base", "surface"}},
    {"xxh", {"base"}},
    {"CLI/", {"host_stub"}},
    {"nlohmann/", {"surface", "stroke", "host_stub"}},
    {"fmt/",
     {"base", "surface", "subdiv", "stroke", "chart", "stamp", "deform", "feature", "refine", "volume",
      "host", "services", "host_stub"}},
    {"Eigen/",
     {"base", "surface", "subdiv", "stroke", "chart", "stamp", "deform", "feature", "refine", "volume",
      "host", "services", "host_stub"}},
    {"CGAL/", {}},
};

struct Include {
  fs::path file;  // relative to the repository
  std::size_t line;
  std::string target;
  bool quoted;
};

/// The folder of the house that holds a file: the part behind sdk/burin, or the first one.
std::string house_folder(const fs::path& file) {
  auto part = file.begin();
  if (part != file.end() && *part == "sdk") std::advance(part, 2);
  return part == file.end() ? "" : part->string();
}

void collect_allowed(const std::string& folder, Names& allowed) {
  if (!allowed.insert(folder).second) return;
  for (const std::string& next : may_include.at(folder)) collect_allowed(next, allowed);
}

bool is_source(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".h" || extension == ".cpp" || extension == ".c" || extension == ".hpp";
}

void read_includes(const fs::path& repository, const fs::path& file, std::vector<Include>& includes) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::ifstream in(repository / file);
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    std::smatch match;
    if (std::regex_match(text, match, pattern)) includes.push_back({file, line, match[2], match[1] == "\""});
  }
}

std::vector<Include> all_includes(const fs::path& repository) {
  std::vector<Include> includes;
  for (const char* root : {"sdk/burin", "brushes", "host_stub"}) {
    if (!fs::exists(repository / root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(repository / root)) {
      if (is_source(entry.path()))
        read_includes(repository, fs::relative(entry.path(), repository), includes);
    }
  }
  return includes;
}

/// The folder that an include of our own points to; nothing for one that is not ours.
std::optional<std::string> own_target(const Include& include) {
  if (include.target.rfind("burin/", 0) == 0) return house_folder("sdk" / fs::path(include.target));
  if (include.quoted) return house_folder((include.file.parent_path() / include.target).lexically_normal());
  return std::nullopt;
}

std::optional<std::string> third_party_fault(const Include& include, const std::string& folder) {
  for (const auto& [prefix, folders] : third_party) {
    if (include.target.rfind(prefix, 0) == 0) {
      if (folders.count(folder)) return std::nullopt;
      return folder + " must not include " + include.target;
    }
  }
  const bool standard = include.target.find_first_of("./") == std::string::npos;
  const bool system = include.target.size() > 2 && include.target.substr(include.target.size() - 2) == ".h";
  if (folder == "abi" && include.target != "stddef.h" && include.target != "stdint.h") {
    return "abi must not include " + include.target;
  }
  if (!standard && !system) return "no rule names " + include.target;
  return std::nullopt;
}

std::optional<std::string> fault(const Include& include) {
  if (include.target == "burin/version.h") return std::nullopt;  // made by CMake, for all
  const std::string folder = house_folder(include.file);
  if (!may_include.count(folder)) return "no rule names the folder " + folder;
  const auto target = own_target(include);
  if (!target) return third_party_fault(include, folder);
  Names allowed;
  collect_allowed(folder, allowed);
  if (allowed.count(*target)) return std::nullopt;
  return folder + " must not include " + include.target;
}

}  // namespace

std::vector<std::string> wrong_includes(const fs::path& repository) {
  std::vector<std::string> faults;
  for (const Include& include : all_includes(repository)) {
    if (const auto what = fault(include)) {
      faults.push_back(include.file.generic_string() + ":" + std::to_string(include.line) + ": " + *what);
    }
  }
  std::sort(faults.begin(), faults.end());
  return faults;
}

std::size_t count_includes(const fs::path& repository) { return all_includes(repository).size(); }

}  // namespace burin::test
