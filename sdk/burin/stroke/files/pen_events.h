#pragma once
#include <burin/stroke/files/import.h>

#include <vector>

namespace burin {

/// An event of a recorder, in the recorder's pixels.
struct PenEvent {
  Sample sample;
  bool contact = false;  ///< the pen touches the tablet
  double pointer = 0;    ///< id of the pointer, for recorders that have several
};

/// Makes strokes of the events in the camera's viewport, by the rules in import.h. Throws FileError if there
/// is no stroke.
Import import_of(const std::filesystem::path& path, const std::vector<PenEvent>& events,
                 const PenFields& fields, const Camera& camera);

/// Fits strokes into the camera's viewport, by the same rules. `counts` are passed on.
Import import_of(const std::filesystem::path& path, std::vector<RecordedStroke> strokes,
                 const ImportCounts& counts, const Camera& camera);

}  // namespace burin
