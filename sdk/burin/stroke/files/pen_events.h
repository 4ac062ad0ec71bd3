#pragma once
#include <burin/stroke/files/import.h>

#include <vector>

namespace burin {

/// A recorder's event, in its own pixels.
struct PenEvent {
  Sample sample;
  bool contact = false;  ///< the pen touches the tablet
  double pointer = 0;    ///< which of several
};

/// The strokes among the events, in the camera's viewport, as import.h describes them. Throws FileError
/// where there is none.
Import import_of(const std::filesystem::path& path, const std::vector<PenEvent>& events,
                 const PenFields& fields, const Camera& camera);

}  // namespace burin
