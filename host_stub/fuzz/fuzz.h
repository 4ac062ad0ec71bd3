#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "validate/probe/check.h"

namespace burin {

struct FuzzOptions {
  double minutes = 0;
  int jobs = 2;                  ///< trials at a time, each in a process of its own
  double time_limit = 30;        ///< seconds after which a trial hangs
  std::filesystem::path bundle;  ///< folder for a trial that fails
};

struct FuzzResult {
  std::size_t trials = 0, refused = 0;  ///< run, and of these those whose parameters the brush refused
  std::string refusal;                  ///< why the last of these was refused; or empty
  std::string failure;                  ///< of the first trial that failed, with what it shrank to; or empty
};

/// Tries the brushes of a module in turn with random strokes, surfaces and parameters until one fails or the
/// time is up. Trial N of a seed is always the same. A failure is shrunk and written to the bundle. Throws
/// Error for a module that cannot be loaded or has no brushes.
FuzzResult fuzz(const validate::Subject& subject, const FuzzOptions& options);

}  // namespace burin
