#pragma once
#include <string>
#include <vector>

namespace burin {

struct ProgramResult {
  int exit_code = -1;    ///< -1 if a signal or the system ended the program
  std::string out, err;  ///< its standard output and standard error
};

/// Runs a program with empty standard input and waits for its end. command[0] is the program's file, which is
/// searched on the PATH unless it contains a slash. On Linux the program is killed if this process ends in
/// any way. Throws FileError, which gives the program, if it cannot be started.
ProgramResult run_program(const std::vector<std::string>& command);

}  // namespace burin
