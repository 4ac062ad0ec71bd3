#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace burin::validate {

/// The handlers of the signals 1 to 31, by their numbers.
std::array<std::uintptr_t, 32> signal_handlers();

/// What belongs to the whole process and is none of a plugin's business.
struct ProcessState {
  std::filesystem::path folder;  ///< the working directory
  std::vector<std::string> environment;
  std::array<std::uintptr_t, 32> handlers;  ///< of signals
  std::array<std::uint64_t, 6> streams;     ///< the files of standard input, output and error
  unsigned mask;                            ///< of the permissions of new files
};

ProcessState process_state();

/// What differs, "the working directory"; null if nothing does.
const char* difference(const ProcessState& a, const ProcessState& b);

}  // namespace burin::validate
