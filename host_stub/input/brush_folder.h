#pragma once
#include <burin/host/brush_library.h>

#include <filesystem>

namespace burin {

/// The folder of this program's stock brushes: beside the program in a build, in lib when installed.
std::filesystem::path own_brush_folder();

/// A library without brushes, whose log is the console and which has all services of Burin. `isolated`: its
/// brushes run in processes of their own.
BrushLibrary brush_library(bool isolated);

/// The text of the option --isolate.
inline constexpr const char* isolate_help =
    "run the brush in a process of its own: one that crashes or hangs is an error like any other";

/// Loads the brushes of the search path and the stock brushes. From then on everything that they print goes
/// to stderr, and a brush that calls exit() or crashes ends the program with an error message that gives its
/// id.
void load_brushes(BrushLibrary& library);

/// The same with the brushes of one module alone.
void load_module(BrushLibrary& library, const std::filesystem::path& module);

}  // namespace burin
