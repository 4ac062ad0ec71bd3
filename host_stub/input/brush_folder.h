#pragma once
#include <burin/host/brush_library.h>

#include <filesystem>

namespace burin {

/// Where the stock brushes of this program are: beside it in a build, in lib when installed.
std::filesystem::path own_brush_folder();

/// Loads the brushes of the search path and the stock brushes. What they print goes to stderr from here on,
/// and one that calls exit() ends the program as an error that names it.
void load_brushes(BrushLibrary& library);

}  // namespace burin
