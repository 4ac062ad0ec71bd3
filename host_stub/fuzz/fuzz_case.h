#pragma once
#include <burin/abi/brush.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

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

/// What random cases have for a file or text parameter; nothing for others.
std::vector<std::string> fuzz_words(burin_param_type type);

/// Which of these a brush begins with, by the ids of the brush and of its parameter.
using TakenWords = std::map<std::pair<std::string, std::string>, std::vector<std::string>>;

/// Random parameters, settings, stroke and surface for a brush; the same for the same seed. Files and texts
/// are mostly such as the brush takes.
FuzzCase random_case(const burin_brush_descriptor& brush, const TakenWords& words, std::uint64_t seed);

}  // namespace burin
