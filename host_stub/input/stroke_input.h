#pragma once
#include <burin/stroke/recording.h>

#include <string>

namespace burin {

/// Reads a complete `.stroke` file with at least one sample. Throws FileError. For a truncated recording the
/// message explains how to repair it; it is not drawn, since half a stroke could not be compared with other
/// results.
Recording read_whole_strokes(const std::string& path);

}  // namespace burin
