#pragma once
#include <burin/host/brush_library.h>

#include <cstddef>
#include <filesystem>

#include "bench/result.h"
#include "bench/suite.h"

namespace burin {

/// Draws the strokes of the case `repeat` times on one surface, taking them back in between, in this process.
/// The figures of memory are those of the case alone only in a process that did nothing else before. `path`:
/// the suite's, to which paths among the brush's parameters are relative. `picture`: a PNG file of the
/// surface with the strokes, written between what is measured, its folder made where needed; empty: none.
/// Throws Error for what is wrong with files or settings, Regression when a repeat gives another result or
/// other counters than the first.
CaseResult run_case(const std::string& path, const BenchCase& bench_case, std::size_t repeat,
                    const std::filesystem::path& picture, const BrushLibrary& brushes,
                    const Progress& progress);

}  // namespace burin
