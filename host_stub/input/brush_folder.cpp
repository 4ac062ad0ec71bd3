// Loads the brushes of a command. At the end of the process a function checks that no plugin called exit().
#include "input/brush_folder.h"

#include <burin/abi/brush.h>
#include <burin/base/error.h>
#include <burin/base/program_file.h>
#include <burin/deform/evaluate/plugin_call.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "system/console.h"
#include "system/crash_line.h"

namespace burin {
namespace {

/// Runs at the end of the process: reports a plugin that called exit() or quick_exit().
void report_exit_in_plugin() {
  const RunningPlugin plugin = PluginCall::running();
  if (!plugin.name) return;
  std::fputs(fmt::format("burin: {} {} called exit()\n", plugin.kind, plugin.name).c_str(), stderr);
  std::_Exit(2);
}

}  // namespace

std::filesystem::path own_brush_folder() { return beside_own_file("brushes"); }

BrushLibrary brush_library(bool isolated) {
  return isolated ? BrushLibrary(log_on_console, Isolation())
                  : BrushLibrary(log_on_console, stamp_services(read_vdb));
}

namespace {

template <class Load>
void load_guarded(const Load& load) {
  keep_plugins_off_standard_output();
  name_plugins_that_crash();
  std::atexit(report_exit_in_plugin);
  std::at_quick_exit(report_exit_in_plugin);
  load();
  // It is registered again because the last registered function runs first: before the destruction of
  // anything that brushes on other threads still use.
  std::atexit(report_exit_in_plugin);
}

}  // namespace

void load_brushes(BrushLibrary& library) {
  load_guarded([&] { library.load_search_path(own_brush_folder()); });
}

void load_module(BrushLibrary& library, const std::filesystem::path& module) {
  load_guarded([&] { library.load(module); });
}

namespace {

constexpr std::string_view module_ending = ".burin";

/// A module that a user names, "NAME.burin" or "NAME.burin:ID".
struct NamedModule {
  std::string file;
  std::string id;  ///< of one of its brushes; empty: all
};

NamedModule named_module(const std::string& name) {
  const std::size_t end = name.rfind(std::string(module_ending) + ":");
  if (end == name.npos || std::filesystem::exists(name)) return {name, ""};
  const std::size_t colon = end + module_ending.size();
  if (colon + 1 == name.size()) throw FileError(name, "the id of a brush is missing after the colon");
  return {name.substr(0, colon), name.substr(colon + 1)};
}

}  // namespace

std::span<const BrushEntry> load_named_brushes(BrushLibrary& library, const std::string& name) {
  const auto& [file, id] = named_module(name);
  if (!std::filesystem::is_regular_file(file)) {
    // Ids have no slashes.
    if (file.ends_with(module_ending) || file.find('/') != file.npos)
      throw FileError(file, std::filesystem::exists(file) ? "is no file" : "there is no such file");
    load_brushes(library);
    return {&library.find(name), 1};
  }
  load_module(library, file);
  if (library.brushes().empty()) throw FileError(file, "has no brushes");
  if (!id.empty()) return {&library.find(id), 1};
  return library.brushes();
}

const BrushEntry& load_named_brush(BrushLibrary& library, const std::string& name) {
  const std::span<const BrushEntry> brushes = load_named_brushes(library, name);
  if (brushes.size() == 1) return brushes.front();
  std::vector<std::string> names;
  for (const BrushEntry& entry : brushes) names.push_back(fmt::format("{}:{}", name, entry.descriptor->id));
  throw FileError(name, fmt::format("has several brushes; name one: {}", fmt::join(names, ", ")));
}

}  // namespace burin
