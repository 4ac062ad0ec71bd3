#include <burin/deform/evaluate/plugin_call.h>
#include <burin/host/session/carry_state.h>
#include <burin/host/session/created_brushes.h>

#include <utility>

namespace burin {

const burin_brush& CreatedBrushes::brush(const BrushEntry& entry, std::vector<std::string>& warnings) {
  Created& kept = created_[entry.descriptor->id];
  if (kept.descriptor == entry.descriptor) return *kept.brush;
  BrushPtr brush = library_->create(entry);
  if (kept.brush) {
    const PluginCall call("brush", entry.descriptor->id);
    if (const std::string lost = carry_state(*kept.brush, *brush); !lost.empty())
      warnings.push_back(std::string(entry.descriptor->id) + ": " + lost);
  }
  kept = {entry.descriptor, std::move(brush)};
  return *kept.brush;
}

}  // namespace burin
