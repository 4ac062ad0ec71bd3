// Writes recordings in the formats that other programs read, or as `.stroke` files; a file is replaced whole.
#include "recordings/written_strokes.h"

#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/text/lower_case.h>
#include <burin/ink/pen_file_writers.h>
#include <burin/stroke/stroke_file.h>

namespace burin::command {
namespace {

using WriteStrokes = void (*)(std::span<const Recording> recordings, std::ostream& out);

WriteStrokes writer_for(const std::filesystem::path& path) {
  const std::string kind = written_kind(path);
  if (kind == "inkml") return write_inkml;
  if (kind == "csv") return write_pen_csv;
  throw FileError(path.string(), "strokes are exported as .inkml or .csv");
}

}  // namespace

std::string written_kind(const std::filesystem::path& path) {
  const std::string extension = in_lower_case(path.extension().string());
  return extension.empty() ? "" : extension.substr(1);
}

void write_stroke_file(const std::filesystem::path& path, const Recording& recording) {
  replace_file(path, [&](const std::filesystem::path& partial) {
    StrokeWriter writer(partial, recording.space, recording.camera, recording.device, PassLines::in_blocks);
    for (const RecordedStroke& stroke : recording.strokes) {
      writer.begin(stroke);
      for (const Sample& sample : stroke.samples) writer.add(sample);
      writer.end();
    }
    writer.flush();
  });
}

void check_pen_file_name(const std::filesystem::path& path) { writer_for(path); }

void write_pen_file(const std::filesystem::path& path, std::span<const Recording> recordings) {
  const WriteStrokes write = writer_for(path);
  write_file_whole(path, [&](std::ostream& out) { write(recordings, out); });
}

}  // namespace burin::command
