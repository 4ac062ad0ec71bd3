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
/// threads are the case's alone. What the process says goes to stderr. Throws Error or Regression, as the
/// process did, with what it said last.
CaseResult run_case_in_process(const std::filesystem::path& burin, const Suite& suite,
                               const std::string& case_name, std::optional<std::size_t> repeat);

/// All cases, each in a process of this command.
SuiteResult run_suite(const Suite& suite, std::optional<std::size_t> repeat, const Progress& progress);

}  // namespace burin
