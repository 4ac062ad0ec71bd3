// Loads modules and finds their brushes. A module of a folder that cannot be loaded is remembered, so that a
// request for one of its brushes fails with the reason.
#include <burin/abi/ext/log.h>
#include <burin/base/error.h>
#include <burin/base/scratch_file.h>
#include <burin/base/text/quoted_word.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/deform/evaluate/plugin_call.h>
#include <burin/deform/evaluate/supported_inputs.h>
#include <burin/host/brush_library.h>
#include <burin/host/isolate/isolated_modules.h>
#include <burin/host/plugin/plugin_module.h>
#include <burin/host/plugin/search_path.h>
#include <burin/host/plugin/services.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace fs = std::filesystem;

/// A module of a folder that was not loaded.
struct RefusedModule {
  std::string why;                   ///< one line with the path of the module
  std::vector<std::string> brushes;  ///< ids of its brushes, if they could be read
};

struct BrushLibrary::Impl {
  Impl(Log log, std::unique_ptr<HostExtensions> extensions)
      : services(std::move(log), std::move(extensions)) {}

  using ModulePtr = std::shared_ptr<const BrushModule>;
  ModulePtr open(const fs::path& module);
  ModulePtr open_anew(const fs::path& module, const fs::path& known);
  void load(const fs::path& module, std::vector<std::string>& ids);
  void refuse(const Error& error, std::vector<std::string> ids);
  void reload(const fs::path& module);
  void add(const std::string& name, const burin_brush_factory& factory);
  void replace(ModulePtr& old, ModulePtr plugin);

  HostServices services;
  std::unique_ptr<isolate::IsolatedModules> isolated;  ///< null: modules are loaded into this process
  std::vector<ModulePtr> modules;
  std::vector<BrushEntry> brushes;
  std::vector<RefusedModule> refused;
};

namespace {

const BrushEntry* find_entry(const std::vector<BrushEntry>& brushes, std::string_view id) {
  const auto found = std::find_if(brushes.begin(), brushes.end(),
                                  [&](const BrushEntry& entry) { return entry.descriptor->id == id; });
  return found == brushes.end() ? nullptr : &*found;
}

void check_supported(const BrushEntry& entry) {
  const burin_brush_descriptor& brush = *entry.descriptor;
  if (const std::uint64_t inputs = brush.inputs_read & ~supported_inputs)
    throw Error(fmt::format("{}: brush {} reads what this host does not offer: {}", entry.module.string(),
                            brush.id, input_names(inputs)));
  if (const std::uint64_t outputs = brush.outputs_written & ~supported_outputs)
    throw Error(fmt::format("{}: brush {} writes what this host does not take: {}", entry.module.string(),
                            brush.id, output_names(outputs)));
}

/// The brushes that are there with those of a module. Throws FileError if there is another with one's id.
std::vector<BrushEntry> with_brushes_of(const BrushModule& module, std::vector<BrushEntry> brushes) {
  for (const burin_brush_descriptor* descriptor : module.brushes()) {
    if (const BrushEntry* other = find_entry(brushes, descriptor->id))
      throw FileError(module.path().string(), fmt::format("brush {} is already there, from {}",
                                                          descriptor->id, other->module.string()));
    brushes.push_back({descriptor, module.path()});
  }
  return brushes;
}

/// Whether this is the file of a loaded module, perhaps by another name.
auto is_file_of(const fs::path& file) {
  return [file](const auto& module) {
    std::error_code error;
    return fs::equivalent(module->path(), file, error);
  };
}

/// A copy in the folder for temporary files. It can be removed once it is loaded.
void copy_module(const fs::path& module, const fs::path& copy) {
  std::error_code error;
  fs::copy_file(module, copy, fs::copy_options::overwrite_existing, error);
  if (error) throw FileError(module.string(), error.message());
}

/// Ends what is only needed while modules are loaded.
struct EndOfLoading {
  const std::unique_ptr<isolate::IsolatedModules>& isolated;
  ~EndOfLoading() {
    if (isolated) isolated->rest();
  }
};

}  // namespace

void BrushDeleter::operator()(const burin_brush* brush) const {
  const PluginCall call("brush", id);
  brush->destroy(brush);
}

BrushLibrary::BrushLibrary(Log log, std::unique_ptr<HostExtensions> extensions)
    : impl_(std::make_unique<Impl>(std::move(log), std::move(extensions))) {}
BrushLibrary::BrushLibrary(Log log, const Isolation& isolation) : BrushLibrary(std::move(log)) {
  impl_->isolated = isolate::isolated_modules(
      isolation, [&services = impl_->services](int severity, std::string_view line) {
        services.write_log(severity, line);
      });
}
BrushLibrary::~BrushLibrary() = default;

BrushLibrary::Impl::ModulePtr BrushLibrary::Impl::open(const fs::path& module) {
  if (isolated) return isolated->open(module);
  return std::make_shared<const PluginModule>(module, module);
}

/// Opens a module that is loaded by the path `known`, from its file as it is now.
BrushLibrary::Impl::ModulePtr BrushLibrary::Impl::open_anew(const fs::path& module, const fs::path& known) {
  if (isolated) return isolated->open(known);
  const ScratchFile copy(fs::temp_directory_path() / "", module);  // takes the mode of no other file
  copy_module(module, copy.path());
  return std::make_shared<const PluginModule>(known, copy.path());
}

/// Loads a module. `ids` receives the ids of its brushes, also if the module is refused because of one of
/// them.
void BrushLibrary::Impl::load(const fs::path& module, std::vector<std::string>& ids) {
  if (std::ranges::any_of(modules, is_file_of(module))) return;
  const std::string name = module.string();
  const PluginCall call("plugin", name.c_str());
  const ModulePtr plugin = open(module);
  for (const burin_brush_descriptor* descriptor : plugin->brushes()) ids.emplace_back(descriptor->id);
  brushes = with_brushes_of(*plugin, brushes);
  modules.push_back(plugin);
}

void BrushLibrary::Impl::reload(const fs::path& module) {
  const auto old = std::ranges::find_if(modules, is_file_of(module));
  if (old == modules.end()) throw FileError(module.string(), "is no module that was loaded");
  const std::string name = module.string();
  const PluginCall call("plugin", name.c_str());
  replace(*old, open_anew(module, (*old)->path()));
}

void BrushLibrary::Impl::add(const std::string& name, const burin_brush_factory& factory) {
  ModulePtr plugin = std::make_shared<const PluginModule>(name, factory);
  const auto old = std::ranges::find(modules, plugin->path(), &BrushModule::path);
  if (old != modules.end()) {
    if (!(*old)->is_of_application()) throw FileError(name, "is a module that was loaded from a file");
    return replace(*old, std::move(plugin));
  }
  brushes = with_brushes_of(*plugin, brushes);
  modules.push_back(std::move(plugin));
}

/// Puts a module with its brushes in the place of an old one.
void BrushLibrary::Impl::replace(ModulePtr& old, ModulePtr plugin) {
  std::vector<BrushEntry> others = brushes;
  std::erase_if(others, [&](const BrushEntry& entry) { return entry.module == plugin->path(); });
  brushes = with_brushes_of(*plugin, std::move(others));
  old = std::move(plugin);
}

void BrushLibrary::Impl::refuse(const Error& error, std::vector<std::string> ids) {
  services.write_log(BURIN_LOG_WARNING, error.what());
  refused.push_back({error.what(), std::move(ids)});
}

void BrushLibrary::load(const fs::path& module) {
  const EndOfLoading end{impl_->isolated};
  std::vector<std::string> ids;
  impl_->load(module, ids);
}

void BrushLibrary::reload(const fs::path& module) {
  const EndOfLoading end{impl_->isolated};
  impl_->reload(module);
}

void BrushLibrary::add(const std::string& name, const burin_brush_factory& factory) {
  impl_->add(name, factory);
}

void BrushLibrary::load_folder(const fs::path& folder) {
  const EndOfLoading end{impl_->isolated};
  for (const fs::path& file : plugin_files(folder)) {
    std::vector<std::string> ids;
    try {
      impl_->load(file, ids);
    } catch (const Error& error) {
      impl_->refuse(error, std::move(ids));
    }
  }
  for (const fs::path& file : misnamed_plugins(folder))
    impl_->refuse(FileError(file.string(), "is a plugin, but only files named *.burin are loaded"), {});
}

void BrushLibrary::load_search_path(const fs::path& own_folder) {
  for (const fs::path& folder : plugin_search_path()) load_folder(folder);
  std::error_code error;
  if (fs::exists(own_folder, error)) load_folder(own_folder);
}

const std::vector<BrushEntry>& BrushLibrary::brushes() const { return impl_->brushes; }

std::vector<std::string> BrushLibrary::refused() const {
  std::vector<std::string> lines;
  for (const RefusedModule& module : impl_->refused) lines.push_back(module.why);
  return lines;
}

const BrushEntry& BrushLibrary::find(std::string_view id) const {
  for (const RefusedModule& module : impl_->refused)
    if (std::ranges::find(module.brushes, id) != module.brushes.end()) throw Error(module.why);
  if (const BrushEntry* entry = find_entry(impl_->brushes, id)) return *entry;
  std::string known, refused;
  for (const BrushEntry& entry : impl_->brushes)
    known += (known.empty() ? "" : ", ") + std::string(entry.descriptor->id);
  for (const RefusedModule& module : impl_->refused) refused += "; not loaded: " + module.why;
  throw Error(
      fmt::format("no brush {}; there are: {}{}", quoted_word(id), known.empty() ? "none" : known, refused));
}

BrushPtr BrushLibrary::create(const BrushEntry& entry) const {
  check_supported(entry);
  const auto plugin = std::find_if(impl_->modules.begin(), impl_->modules.end(),
                                   [&](const auto& module) { return module->path() == entry.module; });
  const PluginCall call("brush", entry.descriptor->id);
  ErrorText error;
  const burin_brush* brush = (*plugin)->create(impl_->services.abi(), entry.descriptor->id, error.abi());
  if (!brush)
    throw Error(fmt::format("{}: brush {} cannot be created: {}", entry.module.string(), entry.descriptor->id,
                            error.line(BURIN_ERROR)));
  if (!is_whole(*brush))
    throw FileError(entry.module.string(), fmt::format("brush {} is incomplete", entry.descriptor->id));
  return BrushPtr(brush, {entry.descriptor->id, *plugin});
}

}  // namespace burin
