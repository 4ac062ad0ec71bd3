// Reads recorded strokes, and refuses those that are cut off.
#include "input/stroke_input.h"

#include <burin/base/error.h>
#include <burin/stroke/stroke_file.h>

#include <algorithm>

namespace burin {

Recording read_whole_strokes(const std::string& path) {
  const Recording recording = read_strokes(path);
  if (recording.cut_off_at) {
    throw FileError(path, std::to_string(*recording.cut_off_at),
                    "the recording is cut off here; to use it, delete this line if it is broken, and append "
                    "{\"end\": true}");
  }
  const bool drawn = std::any_of(recording.strokes.begin(), recording.strokes.end(),
                                 [](const RecordedStroke& stroke) { return !stroke.samples.empty(); });
  if (!drawn) throw FileError(path, "holds no samples");
  return recording;
}

}  // namespace burin
