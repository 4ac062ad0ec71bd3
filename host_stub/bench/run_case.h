#pragma once
#include <burin/host/brush_library.h>

#include <cstddef>
#include <filesystem>
#include <string>

#include "bench/result.h"
#include "bench/suite.h"

namespace burin {

/// Draws the strokes of a case `repeat` times on one surface, with undo in between, in this process. Memory
/// figures are valid only in a process that did nothing else before. `path` is the suite's; paths in brush
/// parameters are relative to it. `picture` is a PNG file to write of the surface with the strokes, outside
/// of the measured time; its folder is created if needed; empty means none. Throws Error for errors in files
/// or settings, Regression if a repeat has another result or other counters than the first.
CaseResult run_case(const std::string& path, const BenchCase& bench_case, std::size_t repeat,
                    const std::filesystem::path& picture, const BrushLibrary& brushes,
                    const Progress& progress);

}  // namespace burin
