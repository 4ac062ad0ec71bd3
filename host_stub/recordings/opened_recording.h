#pragma once
#include <burin/ink/pen_file.h>

#include <optional>
#include <string>

namespace burin::command {

/// A recording of this or of another program.
struct OpenedRecording {
  PenFile file;
  std::optional<Recording> strokes;  ///< of a `.stroke` file

  /// The line at which a `.stroke` file was cut off, if it was.
  std::optional<std::size_t> cut_off_at() const { return strokes ? strokes->cut_off_at : std::nullopt; }
};

/// Opens a `.stroke` file or a pen file of any kind, as its first bytes say. Throws FileError.
OpenedRecording open_recording(const std::string& path);

/// Warns of a recording that was cut off.
void warn_if_cut_off(const std::string& path, std::optional<std::size_t> line);

}  // namespace burin::command
