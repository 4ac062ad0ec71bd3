// Writes the settings of a session's strokes as a recording has them.
#include <burin/host/replay.h>
#include <burin/host/stroke_recorder.h>

#include <utility>

namespace burin {

StrokeRecorder::StrokeRecorder(const std::filesystem::path& path, StrokeSpace space,
                               const std::optional<Camera>& camera, std::string_view device)
    : writer_(path, space, camera, device) {}

ReplaySettings StrokeRecorder::begin(const GivenSettings& settings, const PenFields& fields,
                                     DrawnBy drawn_by) {
  const RecordedStroke stroke{.settings = recorded_settings(settings),
                              .fields = fields,
                              .samples = {},
                              .drawn_by = std::move(drawn_by)};
  ReplaySettings drawn_with = replay_settings(stroke, strokes_, {});
  writer_.begin(stroke);
  ++strokes_;
  return drawn_with;
}

}  // namespace burin
