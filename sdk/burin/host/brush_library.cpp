#include <burin/base/error.h>
#include <burin/deform/error_text.h>
#include <burin/deform/offered.h>
#include <burin/host/brush_library.h>
#include <burin/host/plugin_module.h>
#include <burin/host/search_path.h>
#include <burin/host/services.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace fs = std::filesystem;

struct BrushLibrary::Impl {
  explicit Impl(Log log) : services(log) {}

  HostServices services;
  std::vector<std::unique_ptr<PluginModule>> modules;
  std::vector<BrushEntry> brushes;
};

namespace {

const BrushEntry* find_entry(const std::vector<BrushEntry>& brushes, std::string_view id) {
  const auto found = std::find_if(brushes.begin(), brushes.end(),
                                  [&](const BrushEntry& entry) { return entry.descriptor->id == id; });
  return found == brushes.end() ? nullptr : &*found;
}

void check_offered(const BrushEntry& entry) {
  const burin_brush_descriptor& brush = *entry.descriptor;
  if (const std::uint64_t inputs = brush.inputs_read & ~offered_inputs)
    throw Error(fmt::format("{}: brush {} reads what this host does not offer: {}", entry.module.string(),
                            brush.id, input_names(inputs)));
  if (const std::uint64_t outputs = brush.outputs_written & ~offered_outputs)
    throw Error(fmt::format("{}: brush {} writes what this host does not take: {}", entry.module.string(),
                            brush.id, output_names(outputs)));
}

bool is_whole(const burin_brush& brush) {
  return BURIN_HAS(&brush, burin_brush, end) && brush.destroy && brush.get_extension && brush.begin &&
         brush.evaluate && brush.end;
}

}  // namespace

BrushLibrary::BrushLibrary(Log log) : impl_(std::make_unique<Impl>(log)) {}
BrushLibrary::~BrushLibrary() = default;

void BrushLibrary::load(const fs::path& module) {
  std::error_code error;
  const auto same_file = [&](const auto& loaded) { return fs::equivalent(loaded->path(), module, error); };
  if (std::any_of(impl_->modules.begin(), impl_->modules.end(), same_file)) return;
  auto plugin = std::make_unique<PluginModule>(module);
  std::vector<BrushEntry> brushes = impl_->brushes;
  for (const burin_brush_descriptor* descriptor : plugin->brushes()) {
    if (const BrushEntry* other = find_entry(brushes, descriptor->id))
      throw FileError(module.string(), fmt::format("brush {} is already there, from {}", descriptor->id,
                                                   other->module.string()));
    brushes.push_back({descriptor, module});
  }
  impl_->modules.push_back(std::move(plugin));
  impl_->brushes = std::move(brushes);
}

void BrushLibrary::load_folder(const fs::path& folder) {
  for (const fs::path& file : plugin_files(folder)) load(file);
}

void BrushLibrary::load_search_path(const fs::path& own_folder) {
  for (const fs::path& folder : plugin_search_path()) load_folder(folder);
  std::error_code error;
  if (fs::exists(own_folder, error)) load_folder(own_folder);
}

const std::vector<BrushEntry>& BrushLibrary::brushes() const { return impl_->brushes; }

const BrushEntry& BrushLibrary::find(std::string_view id) const {
  if (const BrushEntry* entry = find_entry(impl_->brushes, id)) return *entry;
  std::string known;
  for (const BrushEntry& entry : impl_->brushes)
    known += (known.empty() ? "" : ", ") + std::string(entry.descriptor->id);
  throw Error(fmt::format("no brush '{}'; there are: {}", id, known.empty() ? "none" : known));
}

BrushPtr BrushLibrary::create(const BrushEntry& entry) const {
  check_offered(entry);
  const auto plugin = std::find_if(impl_->modules.begin(), impl_->modules.end(),
                                   [&](const auto& module) { return module->path() == entry.module; });
  const burin_brush_factory& factory = (*plugin)->factory();
  ErrorText error;
  const burin_brush* brush =
      factory.create(&factory, impl_->services.abi(), entry.descriptor->id, error.abi());
  if (!brush)
    throw Error(fmt::format("{}: brush {} cannot be created: {}", entry.module.string(), entry.descriptor->id,
                            error.line(BURIN_ERROR)));
  if (!is_whole(*brush))
    throw FileError(entry.module.string(), fmt::format("brush {} is incomplete", entry.descriptor->id));
  return BrushPtr(brush);
}

}  // namespace burin
