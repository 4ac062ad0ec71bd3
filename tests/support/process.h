#pragma once
#include <string>
#include <vector>

namespace burin::test {

struct ProcessResult {
  int exit_code = -1;  ///< -1 if a signal ended the process
  std::string out, err;
};

/// Runs a program and waits for its end. It is searched on the PATH unless its name contains a slash.
/// `environment` holds variables "NAME=VALUE" in addition to those of the test. Throws std::runtime_error if
/// it cannot be started.
ProcessResult run_process(const std::vector<std::string>& command,
                          const std::vector<std::string>& environment = {});

}  // namespace burin::test
