#pragma once
#include <burin/stroke/recording.h>

#include <filesystem>
#include <fstream>

namespace burin {

/// Reads a `.stroke` file (JSON Lines, UTF-8). Blank lines, keys and fields that are not known are passed
/// over. A last line without its newline that is no valid JSON is a recording cut off by a crash: left out,
/// with `cut_off_at` set, as it is when the last stroke has no end. Anything else that is wrong throws
/// FileError "PATH:LINE: ...": malformed JSON, wrong arity, a value that is not finite, time that falls
/// within a stroke, a missing header or camera, a sample outside a stroke.
Recording read_strokes(const std::filesystem::path& path);

/// Writes a `.stroke` file line by line as samples arrive, each line handed to the system before the call
/// returns: a crash of the process loses at most the line being written. Numbers are read back bit for bit.
/// Throws FileError; ContractError, with nothing written, for what read_strokes would not accept. One
/// thread.
class StrokeWriter {
 public:
  /// Creates or replaces the file. StrokeSpace::screen needs a camera.
  StrokeWriter(const std::filesystem::path& path, StrokeSpace space, const std::optional<Camera>& camera);

  /// Opens a stroke with the settings and fields of `stroke`; its samples are not written.
  void begin(const RecordedStroke& stroke);
  void add(const Sample& sample);
  void end();

 private:
  void write_line(std::string line);

  std::filesystem::path path_;
  std::ofstream out_;
  StrokeSpace space_;
  PenFields fields_;
  bool open_ = false;  ///< within a stroke
  double last_time_ = 0;
};

}  // namespace burin
