#pragma once
#include <filesystem>
#include <string>

#include "fuzz/trial.h"

namespace burin {

/// A folder with a trial that failed: stroke.stroke, surface.ply, bundle.json and what files it names. It may
/// be moved.
struct Bundle {
  std::filesystem::path module;  ///< absolute
  std::string failure;           ///< what it failed with
  Trial trial;
  double time_limit = 30;  ///< seconds after which the trial hangs
};

/// Throws FileError. `files`: the folder of fuzz_files, which the trial may name.
void write_bundle(const std::filesystem::path& folder, const Bundle& bundle,
                  const std::filesystem::path& files);

/// Throws FileError for what is no bundle.
Bundle read_bundle(const std::filesystem::path& folder);

/// Runs the trial of a bundle in this process, so that a debugger or a sanitizer sees its failure, and tells
/// what comes of it. A trial that hangs ends the process at the time limit with exit code 1, unless a
/// debugger watches it. Throws FileError for what is no bundle, std::runtime_error where the trial fails.
void replay_bundle(const std::filesystem::path& folder);

}  // namespace burin
