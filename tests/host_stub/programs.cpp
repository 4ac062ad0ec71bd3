#include "programs.h"

#include "support/process.h"

namespace burin::test {

bool is_installed(const std::string& program) {
  return run_process({"sh", "-c", "command -v " + program}).exit_code == 0;
}

std::string not_installed(const std::string& program) {
  return program + " is not installed (./dev programs installs it)";
}

}  // namespace burin::test
