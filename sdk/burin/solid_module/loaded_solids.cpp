// Loads OpenVDB when the first solid is merged or shown.
#include <burin/base/error.h>
#include <burin/base/program_file.h>
#include <burin/host/plugin/module.h>
#include <burin/solid_module/loaded_solids.h>
#include <burin/version.h>

#include <filesystem>
#include <memory>

namespace burin {
namespace {

struct LoadedSolids {
  /// Never deleted: the module stays loaded until the process ends, since libraries that it loads do not
  /// expect to be unloaded.
  const Module* module;
  const SolidTools* tools;
};

LoadedSolids load_solids() {
  const std::filesystem::path file = beside_own_file("burin-solids.so");
  auto module = std::make_unique<Module>(file);
  const auto entry =
      reinterpret_cast<decltype(&burin_solid_tools)>(const_cast<void*>(module->symbol("burin_solid_tools")));
  const SolidTools* tools = entry ? entry(BURIN_VERSION) : nullptr;
  if (!tools) throw FileError(file.string(), "belongs to another version of burin");
  return {module.release(), tools};
}

}  // namespace

const SolidTools& solid_tools() {
  static const LoadedSolids loaded = load_solids();
  return *loaded.tools;
}

}  // namespace burin
