#pragma once
#include <burin/abi/plugin.h>
#include <burin/host/plugin/module.h>

#include <filesystem>
#include <span>

namespace burin {

/// A plugin module, loaded, initialised and found to keep the contract. Main thread.
class PluginModule {
 public:
  /// Throws FileError naming the file and what is wrong.
  explicit PluginModule(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const burin_brush_factory& factory() const { return *factory_; }
  std::span<const burin_brush_descriptor* const> brushes() const {
    return {factory_->brushes, factory_->brush_count};
  }

 private:
  /// Between init and deinit.
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
