#pragma once
#include <burin/ink/pen_file.h>

#include <string>

namespace burin {

/// The stream of Ink Serialized Format in a file that is one, or a GIF with one in its comments, or either as
/// base64. Throws FileError for a GIF without.
std::string isf_stream(const PenFileText& file);

}  // namespace burin
