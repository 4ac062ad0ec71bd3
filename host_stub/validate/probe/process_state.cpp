// Reads what a process has once for all of its code.
#include "validate/probe/process_state.h"

#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

namespace burin::validate {

std::array<std::uintptr_t, 32> signal_handlers() {
  std::array<std::uintptr_t, 32> handlers{};
  for (int signal = 1; signal < 32; ++signal) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0)
      handlers[static_cast<std::size_t>(signal)] = reinterpret_cast<std::uintptr_t>(action.sa_handler);
  }
  return handlers;
}

ProcessState process_state() {
  ProcessState state{};
  std::error_code gone;
  state.folder = std::filesystem::current_path(gone);
  for (char** variable = environ; variable && *variable; ++variable)
    state.environment.emplace_back(*variable);
  state.handlers = signal_handlers();
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    struct stat file {};
    const bool open = fstat(stream, &file) == 0;
    const auto at = 2 * static_cast<std::size_t>(stream);
    state.streams[at] = open ? file.st_dev + 1 : 0;
    state.streams[at + 1] = open ? file.st_ino : 0;
  }
  state.mask = umask(0);
  umask(state.mask);
  return state;
}

const char* difference(const ProcessState& a, const ProcessState& b) {
  if (a.folder != b.folder) return "the working directory";
  if (a.environment != b.environment) return "the environment";
  if (a.handlers != b.handlers) return "the handler of a signal";
  if (a.streams != b.streams) return "a standard stream";
  return a.mask != b.mask ? "the permissions of new files" : nullptr;
}

}  // namespace burin::validate
