#pragma once
#include <burin/host/plugin/brush_module.h>
#include <burin/host/plugin/module.h>

#include <optional>

namespace burin {

/// A plugin module that is loaded into this process, initialised and checked, or brushes of the application
/// itself.
class PluginModule : public BrushModule {
 public:
  /// Loads, initialises and checks the module at `path`, which its init gets, from `file`: it or a copy.
  /// Throws FileError, which gives the path and the reason.
  PluginModule(const std::filesystem::path& path, const std::filesystem::path& file);

  /// Checks brushes of the application, which has them for as long as the object lives. Throws FileError,
  /// which gives the name and the reason.
  PluginModule(const std::filesystem::path& name, const burin_brush_factory& factory);

  const std::filesystem::path& path() const override { return path_; }
  bool is_of_application() const override { return !module_; }
  std::span<const burin_brush_descriptor* const> brushes() const override {
    return {factory_->brushes, factory_->brush_count};
  }
  const burin_brush* create(const burin_host* host, const char* brush_id, burin_text* error) const override {
    return factory_->create(factory_, host, brush_id, error);
  }

 private:
  /// Calls init() in the constructor and deinit() in the destructor.
  class Life {
   public:
    Life(const burin_plugin_entry& entry, const std::filesystem::path& path);
    ~Life() { entry_->deinit(); }
    Life(const Life&) = delete;
    Life& operator=(const Life&) = delete;

   private:
    const burin_plugin_entry* entry_;
  };

  std::filesystem::path path_;
  std::optional<Module> module_;  ///< none: the brushes are the application's
  std::optional<Life> life_;
  const burin_brush_factory* factory_;
};

}  // namespace burin
