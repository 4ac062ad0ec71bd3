#pragma once
#include <burin/base/progress.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "bench/result.h"
#include "bench/suite.h"

namespace burin {

/// Runs one case of a suite in a new process of a burin command, so that memory, first touches and threads
/// are those of the case alone. `picture` is the file for a picture of the result; empty means none. The
/// messages of the process go to stderr. Throws Error or Regression, as the process did, with its last
/// message.
CaseResult run_case_in_process(const std::filesystem::path& burin, const Suite& suite,
                               const std::string& case_name, std::optional<std::size_t> repeat,
                               const std::filesystem::path& picture = {});

/// The picture file of the case with this number in a folder; empty if the folder is empty.
std::filesystem::path picture_file(const std::filesystem::path& folder, std::size_t number);

/// Runs all cases, each in a new process of this command, with pictures in this folder unless it is empty.
SuiteResult run_suite(const Suite& suite, std::optional<std::size_t> repeat,
                      const std::filesystem::path& pictures, const Progress& progress);

}  // namespace burin
