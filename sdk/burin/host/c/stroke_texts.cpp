#include <burin/host/c/call.h>
#include <burin/host/c/stroke_texts.h>
#include <burin/host/plugin/brush_params.h>
#include <burin/stroke/files/setting_texts.h>

#include <string>
#include <vector>

namespace burin::c {

GivenSettings read_texts(const char* const* texts, const BrushLibrary& brushes, bool may_refine) {
  std::vector<std::string> all;
  for (; texts && *texts; ++texts) all.emplace_back(*texts);
  GivenSettings settings;
  const auto is_text = [&](const std::string& param) {
    return takes_text(brushes, settings.find(&StrokeSettings::brush), param);
  };
  try {
    read_setting_texts(all, is_text, settings);
  } catch (const Error& fault) {
    reject(fault.what());
  }
  const Refining* refining = settings.find(&StrokeSettings::refining);
  if (refining && refining->kind != Refining::Kind::off && !may_refine)
    reject("refine: must be off, since burin_mesh.refines is not set");
  return settings;
}

}  // namespace burin::c
