#pragma once
#include <burin/stroke/recording.h>
#include <burin/surface/triangle_mesh.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "system/console.h"

namespace burin {

/// A stroke on a surface, to try a brush with.
struct Trial {
  Json settings;          ///< as suites have them; files are named from the folder of the trial
  RecordedStroke stroke;  ///< fields and samples
  TriangleMesh mesh;
};

/// How a trial came out.
enum class Outcome { kept, refused, broke };
struct TrialResult {
  Outcome outcome = Outcome::kept;
  std::string text;  ///< why the brush refused to begin, or what it broke, one line; else empty
};

/// Draws the stroke with a session sample by sample, then whole at its end, then on one thread: the results
/// must agree to the bit and be finite. Parameters that the brush refuses are no fault of it. Throws Error
/// for a module that cannot be loaded.
TrialResult run_trial(const std::filesystem::path& module, const std::filesystem::path& folder,
                      const Trial& trial);

}  // namespace burin
