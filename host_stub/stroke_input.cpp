#include "stroke_input.h"

#include <burin/base/error.h>
#include <burin/stroke/stroke_file.h>

#include <algorithm>

#include "console.h"

namespace burin {

Recording read_strokes_on_console(const std::string& path) {
  Recording recording = read_strokes(path);
  if (recording.cut_off) warn(path + ": the last line is cut off and left out");
  const bool drawn = std::any_of(recording.strokes.begin(), recording.strokes.end(),
                                 [](const RecordedStroke& stroke) { return !stroke.samples.empty(); });
  if (!drawn) throw FileError(path, "holds no samples");
  return recording;
}

}  // namespace burin
