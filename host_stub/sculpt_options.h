#pragma once
#include <burin/host/replay.h>

#include <CLI/CLI.hpp>

namespace burin {

/// Adds --overlap, --accumulate, --clamp, --mirror, --radial, --radial-axis, --symmetry-centre and --dabs.
void add_sculpt_options(CLI::App& command, StrokeOverrides& overrides);

}  // namespace burin
