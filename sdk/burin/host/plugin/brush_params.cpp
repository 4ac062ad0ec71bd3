// Looks up parameters in the descriptors of brushes.
#include <burin/host/plugin/brush_params.h>

#include <algorithm>

namespace burin {
namespace {

/// Whether the brush, or any brush if `id` is null, has a parameter with this name of a type that `is_such`.
template <class Types>
bool has_param_of(const BrushLibrary& brushes, const std::string* id, std::string_view name,
                  const Types& is_such) {
  return std::ranges::any_of(brushes.brushes(), [&](const BrushEntry& entry) {
    const burin_brush_descriptor& brush = *entry.descriptor;
    return (!id || *id == brush.id) &&
           std::any_of(brush.params, brush.params + brush.param_count, [&](const burin_param_info* param) {
             return param->id == name && is_such(param->type);
           });
  });
}

}  // namespace

bool has_param(const BrushLibrary& brushes, const std::string* brush, std::string_view name,
               std::initializer_list<burin_param_type> types) {
  return has_param_of(brushes, brush, name, [&](burin_param_type type) {
    return types.size() == 0 || std::ranges::find(types, type) != types.end();
  });
}

bool takes_text(burin_param_type type) {
  return type == BURIN_PARAM_TEXT || type == BURIN_PARAM_FILE || type == BURIN_PARAM_CHOICE;
}

bool takes_text(const BrushLibrary& brushes, const std::string* brush, std::string_view name) {
  return has_param_of(brushes, brush, name, [](burin_param_type type) { return takes_text(type); });
}

}  // namespace burin
