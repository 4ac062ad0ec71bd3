#include "room_rules.h"

#include <algorithm>
#include <map>
#include <set>

#include "includes.h"

namespace burin::test {
namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

/// What a room may include of the other rooms of its folder; who may include a room may include what that
/// room includes. All may include the folder's top, whose sources may include all rooms.
const std::map<std::string, Names> room_may_include = {
    {"abi/ext", {}},
    {"base/text", {}},
    {"base/threads", {}},
    {"base/trees", {}},
    {"plugin/detail", {"plugin/c"}},
    {"plugin/c", {}},
    {"plugin/entry", {"plugin/c", "plugin/detail"}},
    {"surface/geometry", {}},
    {"surface/topology", {"surface/geometry"}},
    {"surface/base_surface", {"surface/topology"}},
    {"surface/picking", {"surface/topology"}},
    {"surface/points", {"surface/picking"}},
    {"surface/files", {"surface/topology"}},
    {"surface/formats", {"surface/files"}},
    {"stroke/curve", {}},
    {"stroke/files", {}},
    {"ink/parse", {}},
    {"ink/decode", {"ink/parse"}},
    {"ink/kinds", {"ink/decode"}},
    {"ink/fit", {}},
    {"ink/mend", {}},
    {"chart/path", {}},
    {"chart/frames", {"chart/path"}},
    {"chart/front", {"chart/frames"}},
    {"chart/joins", {"chart/front"}},
    {"chart/dabs", {"chart/frames"}},
    {"chart/transfer", {"chart/joins"}},
    {"stamp/files", {}},
    {"stamp/lettering", {}},
    {"deform/evaluate", {}},
    {"deform/blend", {"deform/evaluate"}},
    {"deform/shown", {}},
    {"deform/bake", {}},
    {"deform/solid", {"deform/evaluate"}},
    {"host/plugin", {}},
    {"host/isolate", {"host/plugin"}},
    {"host/session", {"host/plugin"}},
    {"host/c", {"host/plugin"}},
    {"level_set/grid", {}},
    {"brushes/solids", {}},
    {"host_probe/checks", {}},
    {"host_stub/system", {}},
    {"host_stub/new", {"host_stub/system"}},
    {"host_stub/options", {"host_stub/system"}},
    {"host_stub/pictures", {}},
    {"host_stub/input", {"host_stub/options", "host_stub/pictures"}},
    {"host_stub/recordings", {"host_stub/input"}},
    {"host_stub/report", {"host_stub/system"}},
    {"host_stub/chart", {"host_stub/input"}},
    {"host_stub/snap", {"host_stub/chart", "host_stub/recordings"}},
    {"host_stub/watch", {"host_stub/pictures", "host_stub/report"}},
    {"host_stub/fuzz", {"host_stub/input", "host_stub/report", "host_stub/validate/probe"}},
    {"host_stub/replay", {"host_stub/fuzz", "host_stub/watch"}},
    {"host_stub/bench", {"host_stub/replay"}},
    {"host_stub/bench_brush", {"host_stub/bench", "host_stub/validate"}},
    {"host_stub/validate", {"host_stub/validate/checks", "host_stub/fuzz"}},
    {"host_stub/validate/checks", {"host_stub/validate/probe"}},
    {"host_stub/validate/probe", {"host_stub/system"}},
};

/// All rooms that one may include by the rules, without itself unless they lead back to it.
void collect_allowed(const std::string& name, Names& allowed) {
  const auto rule = room_may_include.find(name);
  if (rule == room_may_include.end()) return;
  for (const std::string& next : rule->second)
    if (allowed.insert(next).second) collect_allowed(next, allowed);
}

bool is_room(const std::string& name) { return name.find('/') != std::string::npos; }

using Graph = std::map<fs::path, std::vector<fs::path>>;

/// The rooms of the file's folder that it is in or, at the top, that it brings.
void collect_brought(const fs::path& file, const Graph& includes, Names& brought, std::set<fs::path>& seen) {
  if (!seen.insert(file).second) return;
  if (is_room(room(file))) {
    brought.insert(room(file));
    return;
  }
  const auto found = includes.find(file);
  if (found == includes.end()) return;
  for (const fs::path& next : found->second)
    if (house_folder(next) == house_folder(file)) collect_brought(next, includes, brought, seen);
}

std::string fault(const Include& include, const Graph& includes) {
  const std::string from = room(include.file);
  if (!is_room(from)) return "";
  if (!room_may_include.contains(from)) return "no rule names the room " + from;
  if (include.own.empty() || house_folder(include.own) != house_folder(include.file)) return "";
  if (room(include.own) == from) return "";
  Names allowed, brought;
  std::set<fs::path> seen;
  collect_allowed(from, allowed);
  collect_brought(include.own, includes, brought, seen);
  const auto wrong =
      std::ranges::find_if(brought, [&](const std::string& other) { return !allowed.contains(other); });
  return wrong == brought.end() ? "" : from + " must not include " + *wrong;
}

/// The name of a source without extension and "_test".
std::string source_name(const fs::path& file) {
  std::string name = file.stem().string();
  if (name.ends_with("_test")) name.resize(name.size() - 5);
  return name;
}

}  // namespace

std::vector<std::string> wrong_room_includes(const fs::path& repository) {
  const std::vector<Include> all = all_includes(repository);
  Graph includes;
  for (const Include& include : all)
    if (!include.own.empty()) includes[include.file].push_back(include.own);
  std::vector<std::string> faults;
  for (const Include& include : all)
    if (const std::string what = fault(include, includes); !what.empty())
      faults.push_back(at(include) + ": " + what);
  std::sort(faults.begin(), faults.end());
  return faults;
}

std::vector<std::string> rooms_in_circles() {
  std::vector<std::string> circles;
  for (const auto& [name, next] : room_may_include) {
    Names allowed;
    collect_allowed(name, allowed);
    if (allowed.contains(name)) circles.push_back(name);
  }
  return circles;
}

std::vector<std::string> crowded_folders(const fs::path& repository) {
  std::map<std::string, Names> sources;
  for (const char* root : {"sdk", "brushes", "host_stub", "tests"}) {
    if (!fs::exists(repository / root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(repository / root))
      if (is_source(entry.path()))
        sources[fs::relative(entry.path().parent_path(), repository).generic_string()].insert(
            source_name(entry.path()));
  }
  std::vector<std::string> crowded;
  for (const auto& [folder, names] : sources)
    if (names.size() > 20) crowded.push_back(folder + ": " + std::to_string(names.size()));
  return crowded;
}

std::vector<std::string> misplaced_tests(const fs::path& repository) {
  std::map<std::string, Names> rooms;  // ["FOLDER/NAME"] those that have a source of this name
  for (const char* root : {"sdk/burin", "host_stub"}) {
    if (!fs::exists(repository / root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(repository / root)) {
      const fs::path file = fs::relative(entry.path(), repository);
      if (is_source(file)) rooms[house_folder(file) + "/" + source_name(file)].insert(room(file));
    }
  }
  std::vector<std::string> misplaced;
  for (const auto& entry : fs::recursive_directory_iterator(repository / "tests")) {
    if (!entry.path().filename().string().ends_with("_test.cpp")) continue;
    const fs::path file = fs::relative(entry.path(), repository / "tests");
    const auto found = rooms.find(house_folder(file) + "/" + source_name(file));
    if (found != rooms.end() && !found->second.contains(room(file)))
      misplaced.push_back("tests/" + file.generic_string());
  }
  std::sort(misplaced.begin(), misplaced.end());
  return misplaced;
}

}  // namespace burin::test
