#pragma once
#include <burin/host/brush_library.h>

#include <filesystem>

namespace burin {

/// The folder of this program's stock brushes: beside the program in a build, in lib when installed.
std::filesystem::path own_brush_folder();

/// Loads the brushes of the search path and the stock brushes. From then on everything that they print goes
/// to stderr, and a brush that calls exit() or crashes ends the program with an error message that gives its
/// id.
void load_brushes(BrushLibrary& library);

/// The same with the brushes of one module alone.
void load_module(BrushLibrary& library, const std::filesystem::path& module);

}  // namespace burin
