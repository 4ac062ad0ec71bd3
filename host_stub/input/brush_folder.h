#pragma once
#include <burin/host/brush_library.h>

#include <filesystem>
#include <span>
#include <string>

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

/// Loads what a user names: a module, of which ":ID" behind its name may choose a brush, or the search path
/// for the brush with an id. Returns the brushes of the module, or this one. Throws Error if there is none.
std::span<const BrushEntry> load_named_brushes(BrushLibrary& library, const std::string& name);

/// The same for one brush: of a module the only one. Throws Error, which lists them, if there are several.
const BrushEntry& load_named_brush(BrushLibrary& library, const std::string& name);

/// What these take, for the help.
inline constexpr const char* named_brushes_help =
    "module, NAME.burin, or NAME.burin:ID for one of several brushes; or id of a brush";

}  // namespace burin
