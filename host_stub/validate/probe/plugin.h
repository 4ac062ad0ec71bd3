#pragma once
#include <burin/abi/plugin.h>
#include <burin/host/plugin/module.h>

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "validate/probe/check.h"

namespace burin::validate {

/// The plugin under test, loaded and initialised while the object lives. It checks no more than what it
/// needs, so that a fault is found by the one check whose business it is.
class Plugin {
 public:
  /// `path` is what init is told, the module's file unless given. Throws Failed.
  explicit Plugin(const Subject& subject, const char* path = nullptr);
  ~Plugin();
  Plugin(const Plugin&) = delete;
  Plugin& operator=(const Plugin&) = delete;

  const burin_plugin_entry& entry() const { return *entry_; }
  const burin_brush_factory& factory() const { return *factory_; }
  std::span<const burin_brush_descriptor* const> brushes() const {
    return {factory_->brushes, factory_->brush_count};
  }

 private:
  Module module_;
  const burin_plugin_entry* entry_;
  const burin_brush_factory* factory_ = nullptr;
};

/// The entry that a module exports. Throws Failed if it has none or one of another ABI.
const burin_plugin_entry& entry_of(const Module& module);

/// Calls `check` for each brush of the plugin. A failure's text begins with the id of the brush. Throws
/// Skipped if all calls did.
void each_brush(const Subject& subject,
                const std::function<void(const Plugin&, const burin_brush_descriptor&)>& check);

/// A null-terminated list of texts.
std::span<const char* const> list_of(const char* const* texts);

}  // namespace burin::validate
