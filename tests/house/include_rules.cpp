#include "include_rules.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "includes.h"

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
    {"ink", {"stroke"}},
    {"chart", {"stroke"}},
    {"stamp", {"base"}},
    {"image_codec", {"stamp"}},
    {"image_module", {"image_codec"}},
    {"deform", {"abi", "chart", "volume"}},
    {"feature", {"chart"}},
    {"refine", {"surface"}},
    {"volume", {"chart"}},
    {"along", {"volume"}},
    {"remesh", {"base"}},
    {"level_set", {"volume", "remesh"}},
    {"host",
     {"abi", "math", "plugin", "base", "surface", "stroke", "chart", "deform", "feature", "refine", "volume",
      "along"}},
    {"services", {"host", "stamp"}},
    {"solid_module", {"host", "level_set"}},
    {"c", {"services", "solid_module", "subdiv", "feature"}},
    {"brushes", {"abi", "math", "plugin"}},
    {"brush_process", {"services", "level_set"}},
    {"host_probe", {"abi"}},
    {"host_stub", {"services", "level_set", "subdiv", "ink", "feature"}},
};

/// Third-party headers, by how they begin, and the folders that may see them.
const std::map<std::string, Names> third_party = {
    {"opensubdiv/", {"subdiv"}},
    {"openvdb/", {"level_set"}},
    {"OpenMesh/", {"remesh"}},
    {"OpenImageIO/", {"image_codec"}},
    {"freetype/", {"stamp"}},
    {"harfbuzz/", {"stamp"}},
    {"nanoflann", {"surface"}},
    {"tbb/", {"base", "surface"}},
    {"oneapi/tbb", {"base", "surface"}},
    {"pugixml", {"ink"}},
    {"archive", {"ink"}},
    {"yaml-cpp/", {"ink"}},
    {"xxh", {"base"}},
    {"CLI/", {"host_stub"}},
    {"nlohmann/", {"base", "surface", "stroke", "ink", "host_stub"}},
    {"fmt/",
     {"base", "surface", "subdiv", "stroke", "ink", "chart", "stamp", "image_codec", "deform", "feature",
      "refine", "volume", "along", "remesh", "level_set", "host", "services", "host_stub"}},
    {"Eigen/",
     {"base", "surface", "subdiv", "stroke", "ink", "chart", "stamp", "deform", "feature", "refine", "volume",
      "along", "remesh", "level_set", "host", "services", "host_stub"}},
    {"CGAL/", {}},
};

void collect_allowed_folders(const std::string& folder, Names& allowed) {
  if (!allowed.insert(folder).second) return;
  for (const std::string& next : may_include.at(folder)) collect_allowed_folders(next, allowed);
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
  if (include.own.empty()) return third_party_fault(include, folder);
  Names allowed;
  collect_allowed_folders(folder, allowed);
  if (allowed.count(house_folder(include.own))) return std::nullopt;
  return folder + " must not include " + include.target;
}

}  // namespace

std::vector<std::string> wrong_includes(const fs::path& repository) {
  std::vector<std::string> faults;
  for (const Include& include : all_includes(repository)) {
    if (const auto what = fault(include)) faults.push_back(at(include) + ": " + *what);
  }
  std::sort(faults.begin(), faults.end());
  return faults;
}

std::size_t count_includes(const fs::path& repository) { return all_includes(repository).size(); }

}  // namespace burin::test
