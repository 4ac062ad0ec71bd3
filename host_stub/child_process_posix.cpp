#if !defined(_WIN32)
#include <burin/base/error.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "capture_file.h"
#include "child_process.h"

extern char** environ;

namespace burin {
namespace {

pid_t start(std::vector<std::string> command, const CaptureFile& out, const CaptureFile& err) {
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.stream()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(err.stream()), STDERR_FILENO);
  pid_t process = 0;
  const int error = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw FileError(command[0], std::generic_category().message(error));
  return process;
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& command) {
  const CaptureFile out, err;
  const pid_t process = start(command, out, err);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out.text(), err.text()};
}

}  // namespace burin
#endif
