#pragma once
#include <burin/stroke/recording.h>

#include <string>

namespace burin {

/// Reads a `.stroke` file; warns of one that a crash cut off. Throws FileError, also when no stroke of it
/// has a sample.
Recording read_strokes_on_console(const std::string& path);

}  // namespace burin
