#pragma once
#include <burin/stroke/recording.h>

#include <filesystem>
#include <fstream>
#include <string_view>

// read_strokes() may be called on any thread, also on several at once.
namespace burin {

/// Reads a `.stroke` file (docs/stroke_format.md). Ignores blank lines and unknown keys and fields. A last
/// line without newline that is not valid JSON was cut off by a crash of the recorder: it is left out and
/// `cut_off_at` is set, as it is when the last stroke has no end. All other errors throw FileError
/// "PATH:LINE: ...": malformed JSON, a wrong number of values, a value that is not finite, time that falls
/// within a stroke, a missing header or camera, a sample outside a stroke.
Recording read_strokes(const std::filesystem::path& path);

/// Reads the text of such a file; `path` is for messages.
Recording read_strokes(const std::filesystem::path& path, std::string_view text);

/// Those of the settings that a recording keeps (docs/stroke_format.md). Throws ContractError for values that
/// read_strokes() would refuse.
GivenSettings recorded_settings(const GivenSettings& given);

/// When a StrokeWriter passes its lines to the operating system.
enum class PassLines {
  at_once,    ///< each before the call that wrote it returns: a crash loses at most the line being written
  in_blocks,  ///< many together, which is faster; StrokeWriter::flush() passes the last ones
};

/// Writes a `.stroke` file line by line as samples arrive. read_strokes()
/// reads the numbers back bit for bit. Throws FileError; ContractError, without writing, for values that
/// read_strokes() would refuse. One thread.
class StrokeWriter {
 public:
  /// Creates or replaces the file. StrokeSpace::screen needs a camera. `device`: Recording::device.
  StrokeWriter(const std::filesystem::path& path, StrokeSpace space, const std::optional<Camera>& camera,
               std::string_view device = {}, PassLines pass_lines = PassLines::at_once);

  /// Begins a stroke with what holds for `stroke` as a whole. Does not write its samples.
  void begin(const RecordedStroke& stroke);
  void add(const Sample& sample);
  void end();  ///< ends the stroke

  /// Passes all lines to the operating system.
  void flush();

 private:
  void write_line(std::string line);

  std::filesystem::path path_;
  std::ofstream out_;
  StrokeSpace space_;
  PassLines pass_lines_;
  PenFields fields_;
  bool open_ = false;  ///< within a stroke
  double last_time_ = 0;
};

}  // namespace burin
