#include "bench/suite_params.h"

#include <filesystem>
#include <string_view>

namespace burin {
namespace {

/// Whether some brush has a parameter of this name that is a file.
bool is_file_param(const BrushLibrary& brushes, std::string_view name) {
  for (const BrushEntry& entry : brushes.brushes()) {
    for (std::uint32_t i = 0; i < entry.descriptor->param_count; ++i) {
      const burin_param_info& param = *entry.descriptor->params[i];
      if (param.type == BURIN_PARAM_FILE && param.id == name) return true;
    }
  }
  return false;
}

}  // namespace

ParamSettings params_of_suite(const std::string& path, ParamSettings params, const BrushLibrary& brushes) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (auto& [name, setting] : params) {
    auto* text = std::get_if<std::string>(&setting);
    if (text && is_file_param(brushes, name)) *text = (folder / *text).lexically_normal().string();
  }
  return params;
}

}  // namespace burin
