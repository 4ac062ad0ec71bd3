#pragma once
#include <burin/stroke/files/import.h>

#include <string>
#include <vector>

namespace burin {

/// An event of a recorder, in the recorder's pixels.
struct PenEvent {
  Sample sample;
  bool contact = false;  ///< the pen touches the tablet
  double pointer = 0;    ///< id of the pointer, for recorders that have several
};

/// The events of a recording.
struct PenEvents {
  std::vector<PenEvent> events;
  PenFields fields;
};

// The events in the text of a recording of another program (import.h). `path` is for messages.
PenEvents mypaint_events(const std::string& text, const std::filesystem::path& path);
PenEvents pointer_events(const std::string& text, const std::filesystem::path& path);
PenEvents svc_events(const std::string& text, const std::filesystem::path& path);

/// The strokes of events, in the recorder's pixels: one of each run in which a pointer touches the tablet.
std::vector<RecordedStroke> contact_strokes(const PenEvents& recorded, ImportCounts& counts);

/// Makes strokes of the events in the camera's viewport, by the rules in import.h. Throws FileError if there
/// is no stroke.
Import import_of(const std::filesystem::path& path, const PenEvents& recorded, const Camera& camera);

/// Fits strokes into the camera's viewport, by the same rules. `counts` are passed on.
Import import_of(const std::filesystem::path& path, std::vector<RecordedStroke> strokes,
                 const ImportCounts& counts, const Camera& camera);

}  // namespace burin
