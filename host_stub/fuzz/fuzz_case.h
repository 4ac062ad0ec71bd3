#pragma once
#include <burin/abi/brush.h>

#include <array>
#include <cstdint>

#include "fuzz/fuzz_surface.h"
#include "fuzz/trial.h"

namespace burin {

/// A random trial and what its surface was made from.
struct FuzzCase {
  Trial trial;
  FuzzSurface surface;
};

/// The names of the files that random cases name in the trial's folder: those of validate::WorkFolder.
inline constexpr std::array fuzz_files = {"stamp.png", "solid.vdb"};

/// Random parameters, settings, stroke and surface for a brush; the same for the same seed.
FuzzCase random_case(const burin_brush_descriptor& brush, std::uint64_t seed);

}  // namespace burin
