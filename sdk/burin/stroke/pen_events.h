#pragma once
#include <burin/stroke/recording.h>

#include <vector>

namespace burin {

/// A recorder's event, in its own pixels.
struct PenEvent {
  Sample sample;
  bool contact = false;  ///< the pen touches the tablet
};

/// The strokes among the events, in the camera's viewport, as import.h describes them. Empty where no
/// stroke has two distinct places.
Recording recording_of(const std::vector<PenEvent>& events, const PenFields& fields, const Camera& camera);

}  // namespace burin
