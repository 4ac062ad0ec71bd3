// Resolves the files among a suite's brush parameters against the suite's folder.
#include "input/suite_params.h"

#include <burin/host/plugin/brush_params.h>

#include <filesystem>

namespace burin {

GivenSettings settings_of_suite(const std::string& path, const GivenSettings& settings,
                                const BrushLibrary& brushes) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  GivenSettings seen = settings;
  if (seen.find(&StrokeSettings::along)) {
    AlongSettings& along = seen[&StrokeSettings::along];
    for (MeshSource* source : {&along.middle, &along.start, &along.end})
      if (!source->file.empty()) source->file = (folder / source->file).lexically_normal().string();
  }
  if (!settings.find(&StrokeSettings::params)) return seen;
  for (auto& [name, setting] : seen[&StrokeSettings::params]) {
    auto* text = std::get_if<std::string>(&setting);
    if (text && !text->empty() &&
        has_param(brushes, settings.find(&StrokeSettings::brush), name, {BURIN_PARAM_FILE}))
      *text = (folder / *text).lexically_normal().string();
  }
  return seen;
}

}  // namespace burin
