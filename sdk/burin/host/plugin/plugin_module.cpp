// Loads a module and checks its entry, its factory and all its descriptors, on which later code relies.
#include <burin/base/error.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/host/plugin/descriptor_check.h>
#include <burin/host/plugin/plugin_module.h>
#include <burin/host/plugin/utf8_path.h>
#include <fmt/format.h>

#include <utility>

namespace burin {
namespace {

FileError incomplete(const std::filesystem::path& path) {
  return FileError(path.string(), "its plugin entry is incomplete");
}

const burin_plugin_entry* checked_entry(const Module& module, const std::filesystem::path& path) {
  const auto* entry = static_cast<const burin_plugin_entry*>(module.symbol(BURIN_PLUGIN_SYMBOL));
  if (!entry)
    throw FileError(path.string(), "is no Burin plugin: it does not export '" BURIN_PLUGIN_SYMBOL "'");
  if (!BURIN_HAS(entry, burin_plugin_entry, abi_major)) throw incomplete(path);
  if (entry->abi_major != BURIN_ABI_MAJOR)
    throw FileError(path.string(), fmt::format("is made for version {} of the plugin interface, not for {}",
                                               entry->abi_major, BURIN_ABI_MAJOR));
  if (!BURIN_HAS(entry, burin_plugin_entry, get_factory) || !entry->init) throw incomplete(path);
  return entry;
}

const burin_brush_factory* checked_factory(const burin_brush_factory* factory,
                                           const std::filesystem::path& path) {
  if (!factory) throw FileError(path.string(), "offers no brushes");
  if (!BURIN_HAS(factory, burin_brush_factory, create) || !factory->create ||
      (factory->brush_count > 0 && !factory->brushes))
    throw FileError(path.string(), "its brush factory is incomplete");
  for (std::uint32_t i = 0; i < factory->brush_count; ++i) {
    const burin_brush_descriptor* descriptor = factory->brushes[i];
    if (!descriptor) throw FileError(path.string(), fmt::format("brush {} has no descriptor", i));
    if (const std::string problem = descriptor_problem(*descriptor); !problem.empty())
      throw FileError(path.string(), problem);
  }
  return factory;
}

}  // namespace

PluginModule::Life::Life(const burin_plugin_entry& entry, const std::filesystem::path& path)
    : entry_(&entry) {
  ErrorText error;
  const burin_status status = entry.init(utf8(path).c_str(), error.abi());
  if (status != BURIN_OK) throw FileError(path.string(), "cannot be initialised: " + error.line(status));
  if (entry.deinit && entry.get_factory) return;
  if (entry.deinit) entry.deinit();
  throw incomplete(path);
}

PluginModule::PluginModule(const std::filesystem::path& path, const std::filesystem::path& file)
    : path_(path), module_(std::in_place, file, path) {
  const burin_plugin_entry& entry = *checked_entry(*module_, path);
  life_.emplace(entry, path);
  factory_ =
      checked_factory(static_cast<const burin_brush_factory*>(entry.get_factory(BURIN_BRUSH_FACTORY)), path);
}

PluginModule::PluginModule(const std::filesystem::path& name, const burin_brush_factory& factory)
    : path_(name), factory_(checked_factory(&factory, name)) {}

}  // namespace burin
