// Looks up parameters in the descriptors of brushes.
#include <burin/host/plugin/brush_params.h>

#include <algorithm>

namespace burin {
namespace {

bool has_param(const burin_brush_descriptor& brush, std::string_view name,
               std::initializer_list<burin_param_type> types) {
  return std::any_of(brush.params, brush.params + brush.param_count, [&](const burin_param_info* param) {
    return param->id == name && std::ranges::find(types, param->type) != types.end();
  });
}

}  // namespace

bool has_param(const BrushLibrary& brushes, const std::string* brush, std::string_view name,
               std::initializer_list<burin_param_type> types) {
  return std::ranges::any_of(brushes.brushes(), [&](const BrushEntry& entry) {
    return (!brush || *brush == entry.descriptor->id) && has_param(*entry.descriptor, name, types);
  });
}

bool takes_text(const BrushLibrary& brushes, const std::string* brush, std::string_view name) {
  return has_param(brushes, brush, name, {BURIN_PARAM_TEXT, BURIN_PARAM_FILE, BURIN_PARAM_CHOICE});
}

}  // namespace burin
