// Gives StrokeRecorder to programs in C.
#include <burin/base/error.h>
#include <burin/base/text/json_value.h>
#include <burin/host/c/call.h>
#include <burin/host/c/pen_fields.h>
#include <burin/host/recorder.h>
#include <burin/host/stroke_recorder.h>
#include <burin/stroke/files/setting_table.h>

#include <cstddef>
#include <string>

struct burin_recorder {
  burin::StrokeRecorder recorder;
  burin::PenFields fields;  ///< of the open stroke
};

namespace burin {
namespace {

using c::fields_of;
using c::known_members;
using c::reject;

void check_recorder(const burin_recorder* recorder) { c::require(recorder, "the recorder"); }

/// Runs `body` for a call from C.
template <class Body>
burin_status called(burin_text* error, const Body& body) {
  return plugin::guarded(error, [&] {
    try {
      body();
    } catch (const ContractError& fault) {
      reject(fault.what());
    }
  });
}

StrokeSpace space_of(burin_stroke_space space) {
  if (space == BURIN_SPACE_OBJECT) return StrokeSpace::object;
  if (space != BURIN_SPACE_SCREEN) reject("space is neither object nor screen");
  return StrokeSpace::screen;
}

std::optional<Camera> camera_of(const burin_recorder_camera* given) {
  if (!given) return std::nullopt;
  Camera camera;
  camera.view = Eigen::Map<const Eigen::Matrix4d>(given->view);
  camera.projection = Eigen::Map<const Eigen::Matrix4d>(given->projection);
  camera.width = given->width;
  camera.height = given->height;
  return camera;
}

GivenSettings settings_of(const char* text) {
  GivenSettings settings;
  if (!text) reject("settings are missing");
  try {
    read_settings(JsonValue::parse(text, "settings"), SettingsOf::recording, settings);
  } catch (const Error& fault) {
    reject(fault.what());
  }
  return settings;
}

/// Reads those fields alone that the pen reports.
Sample sample_of(const burin_recorded_sample& given, const PenFields& fields) {
  Sample sample;
  sample.position = Vec3d(given.position[0], given.position[1], given.position[2]);
  c::read_pen(given, fields, sample);
  return sample;
}

}  // namespace
}  // namespace burin

burin_recorder* burin_recorder_open(const burin_recorder_options* options, burin_text* error) {
  using namespace burin;
  burin_recorder* opened = nullptr;
  called(error, [&] {
    const burin_recorder_options known =
        known_members(options, options && BURIN_HAS(options, burin_recorder_options, camera), "options");
    if (!known.path) reject("the path is missing");
    const std::string device = known.device ? known.device : "";
    opened = new burin_recorder{StrokeRecorder(std::filesystem::path(known.path), space_of(known.space),
                                               camera_of(known.camera), device),
                                {}};
  });
  return opened;
}

burin_status burin_recorder_begin(burin_recorder* recorder, const burin_recorded_stroke* stroke,
                                  burin_text* error) {
  using namespace burin;
  return called(error, [&] {
    check_recorder(recorder);
    const burin_recorded_stroke known =
        known_members(stroke, stroke && BURIN_HAS(stroke, burin_recorded_stroke, settings), "the stroke");
    const GivenSettings settings = settings_of(known.settings);
    if (!settings.find(&StrokeSettings::brush) || !settings.find(&StrokeSettings::radius))
      reject("settings lack brush or radius");
    const PenFields fields = fields_of(known.fields);
    recorder->recorder.begin(settings, fields, {known.tool ? known.tool : "", known.eraser != 0});
    recorder->fields = fields;
  });
}

burin_status burin_recorder_add(burin_recorder* recorder, const burin_recorded_sample* sample,
                                burin_text* error) {
  using namespace burin;
  return called(error, [&] {
    check_recorder(recorder);
    const burin_recorded_sample known =
        known_members(sample, sample && BURIN_HAS(sample, burin_recorded_sample, barrel), "the sample");
    recorder->recorder.add(sample_of(known, recorder->fields));
  });
}

burin_status burin_recorder_end(burin_recorder* recorder, burin_text* error) {
  using namespace burin;
  return called(error, [&] {
    check_recorder(recorder);
    recorder->recorder.end();
  });
}

void burin_recorder_close(burin_recorder* recorder) { delete recorder; }
