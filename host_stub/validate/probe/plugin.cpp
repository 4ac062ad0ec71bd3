// Loads the plugin under test step by step; each step that fails ends the check.
#include "validate/probe/plugin.h"

#include <fmt/format.h>

#include <cstddef>

namespace burin::validate {

const burin_plugin_entry& entry_of(const Module& module) {
  const auto* entry = static_cast<const burin_plugin_entry*>(module.symbol(BURIN_PLUGIN_SYMBOL));
  require(entry, "does not export '" BURIN_PLUGIN_SYMBOL "'");
  require(BURIN_HAS(entry, burin_plugin_entry, get_factory), "its plugin entry is too small");
  require(entry->abi_major == BURIN_ABI_MAJOR,
          fmt::format("is made for version {} of the plugin interface", entry->abi_major));
  require(entry->init && entry->deinit && entry->get_factory, "its plugin entry lacks a function");
  return *entry;
}

Plugin::Plugin(const Subject& subject, const char* path)
    : module_(subject.module), entry_(&entry_of(module_)) {
  require(entry_->init(path ? path : subject.module.c_str(), nullptr) == BURIN_OK, "init fails");
  factory_ = static_cast<const burin_brush_factory*>(entry_->get_factory(BURIN_BRUSH_FACTORY));
  const bool whole = factory_ && BURIN_HAS(factory_, burin_brush_factory, create) && factory_->create &&
                     (factory_->brushes || factory_->brush_count == 0);
  if (whole) return;
  entry_->deinit();
  throw Failed("has no whole brush factory");
}

Plugin::~Plugin() { entry_->deinit(); }

void each_brush(const Subject& subject,
                const std::function<void(const Plugin&, const burin_brush_descriptor&)>& check) {
  const Plugin plugin(subject);
  std::string reason = "the module has no brushes";
  bool ran = false;
  for (const burin_brush_descriptor* brush : plugin.brushes()) {
    const std::string id = brush->id ? brush->id : "a brush without an id";
    try {
      tell_where(id + ": ", [&] { check(plugin, *brush); });
      ran = true;
    } catch (const Skipped& skipped) {
      reason = skipped.what();
    }
  }
  if (!ran) throw Skipped(reason);
}

std::span<const char* const> list_of(const char* const* texts) {
  std::size_t count = 0;
  while (texts && texts[count]) ++count;
  return {texts, count};
}

}  // namespace burin::validate
