#pragma once
#include <string>
#include <vector>

namespace burin::test {

struct ProcessResult {
  int exit_code = -1;  ///< -1 when a signal ended the process
  std::string out, err;
};

/// Runs a program, found on the PATH unless its name holds a slash, to its end. `environment`: variables
/// "NAME=VALUE" besides those of the test. Throws std::runtime_error when it cannot be started.
ProcessResult run_process(const std::vector<std::string>& command,
                          const std::vector<std::string>& environment = {});

}  // namespace burin::test
