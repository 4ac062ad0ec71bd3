#pragma once
#include <string>
#include <vector>

namespace burin {

struct ProgramResult {
  int exit_code = -1;  ///< -1 when the system ended the program
  std::string out, err;
};

/// Runs a program to its end with nothing on its standard input. command[0]: the program's file, found on the
/// PATH unless it holds a slash. It ends with this process, however that ends, where the system is Linux.
/// Throws FileError naming it when it cannot be started.
ProgramResult run_program(const std::vector<std::string>& command);

}  // namespace burin
