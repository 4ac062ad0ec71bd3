#include "bench/suite_params.h"

#include <filesystem>

#include "input/brush_params.h"

namespace burin {

ParamSettings params_of_suite(const std::string& path, const StrokeOverrides& overrides,
                              const BrushLibrary& brushes) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  ParamSettings params = overrides.params;
  for (auto& [name, setting] : params) {
    auto* text = std::get_if<std::string>(&setting);
    if (text && !text->empty() && has_param(brushes, overrides.brush, name, {BURIN_PARAM_FILE}))
      *text = (folder / *text).lexically_normal().string();
  }
  return params;
}

}  // namespace burin
