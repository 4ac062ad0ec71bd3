#pragma once
#include <burin/host/replay.h>

#include "cli_fwd.h"

namespace burin {

/// Adds --overlap, --accumulate, --clamp, --mirror, --radial, --radial-axis, --symmetry-centre and --dabs.
void add_sculpt_options(CLI::App& command, StrokeOverrides& overrides);

}  // namespace burin
