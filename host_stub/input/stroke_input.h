#pragma once
#include <burin/stroke/recording.h>

#include <string>

namespace burin {

/// Reads a `.stroke` file that is whole and has a sample. Throws FileError; of a recording that was cut off
/// the message says how to mend it, since a replay of half a stroke is no comparison.
Recording read_whole_strokes(const std::string& path);

}  // namespace burin
