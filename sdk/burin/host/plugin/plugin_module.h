#pragma once
#include <burin/abi/plugin.h>
#include <burin/host/plugin/module.h>

#include <filesystem>
#include <span>

namespace burin {

/// A plugin module that is loaded, initialised and checked. All functions are to be called on the main
/// thread.
class PluginModule {
 public:
  /// Loads, initialises and checks the module at `path`, which its init gets, from `file`: it or a copy.
  /// Throws FileError, which gives the path and the reason.
  PluginModule(const std::filesystem::path& path, const std::filesystem::path& file);

  const std::filesystem::path& path() const { return path_; }
  const burin_brush_factory& factory() const { return *factory_; }
  std::span<const burin_brush_descriptor* const> brushes() const {
    return {factory_->brushes, factory_->brush_count};
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
  Module module_;
  const burin_plugin_entry* entry_;
  Life life_;
  const burin_brush_factory* factory_;
};

}  // namespace burin
