#pragma once
#include <burin/base/progress.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "bench/result.h"
#include "bench/suite.h"

namespace burin {

/// Has a burin command run one case of a suite in a process of its own, so that memory, first touches and
/// threads are the case's alone. `picture`: the file that it is to draw the result into; empty: none. What
/// the process says goes to stderr. Throws Error or Regression, as the process did, with what it said last.
CaseResult run_case_in_process(const std::filesystem::path& burin, const Suite& suite,
                               const std::string& case_name, std::optional<std::size_t> repeat,
                               const std::filesystem::path& picture = {});

/// The picture of the case of this number in a folder; nothing in no folder.
std::filesystem::path picture_file(const std::filesystem::path& folder, std::size_t number);

/// All cases, each in a process of this command, with pictures in this folder unless it is empty.
SuiteResult run_suite(const Suite& suite, std::optional<std::size_t> repeat,
                      const std::filesystem::path& pictures, const Progress& progress);

}  // namespace burin
