#pragma once
#include <burin/base/error.h>
#include <burin/stroke/stroke_file.h>

#include <string>

namespace burin::c {

/// Reads a recording. Throws FileError, also for one that was cut off: half a stroke is not drawn.
inline Recording read_whole_recording(const char* path) {
  Recording recording = read_strokes(path);
  if (recording.cut_off_at)
    throw FileError(path, std::to_string(*recording.cut_off_at), "the recording is cut off here");
  return recording;
}

}  // namespace burin::c
