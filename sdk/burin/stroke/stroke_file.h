#pragma once
#include <burin/stroke/recording.h>

#include <filesystem>
#include <fstream>

namespace burin {

/// Reads a `.stroke` file (JSON Lines). Unknown keys are accepted. A last line without its newline that is
/// no valid JSON is a recording cut off by a crash: left out, with `cut_off` set. Anything else that is
/// wrong throws FileError "PATH:LINE: ...": malformed JSON, wrong arity, a value that is not finite, time
/// that falls, a missing header or camera, a sample outside a stroke.
Recording read_strokes(const std::filesystem::path& path);

/// Writes a `.stroke` file line by line as samples arrive, each line flushed to the system before the next
/// call returns: a crash loses at most the line being written. Throws FileError. One thread.
class StrokeWriter {
 public:
  /// Creates or replaces the file. `camera` is needed for StrokeSpace::screen.
  StrokeWriter(const std::filesystem::path& path, StrokeSpace space, const std::optional<Camera>& camera);

  /// Opens a stroke with the settings and fields of `stroke`; its samples are not written.
  void begin(const RecordedStroke& stroke);
  void add(const Sample& sample);
  void end();

 private:
  void write_line(const std::string& line);

  std::filesystem::path path_;
  std::ofstream out_;
  StrokeSpace space_;
  PenFields fields_;
};

}  // namespace burin
