// Runs programs by fork() and execvp(), with temporary files for their output. On Linux they end with this
// process.
#if !defined(_WIN32)
#include <burin/base/error.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include "system/capture_file.h"
#include "system/child_process.h"

namespace burin {
namespace {

/// Runs in the child after fork(). It must not allocate memory or take locks, since other threads of the
/// parent may have held locks at the fork.
[[noreturn]] void become_program(char* const* arguments, int out, int err, int failure, pid_t parent) {
#if defined(__linux__)
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
#endif
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 &&
      dup2(err, STDERR_FILENO) >= 0)
    execvp(arguments[0], arguments);
  const int error = errno;
  if (write(failure, &error, sizeof error) < 0) _exit(2);
  _exit(1);
}

/// The error number that the child sends through the pipe if it cannot start the program; 0 if it could.
int error_of_start(int failure) {
  int error = 0;
  while (read(failure, &error, sizeof error) < 0 && errno == EINTR) {
  }
  return error;
}

/// Starts the program by fork(), since posix_spawn() cannot make the child end with its parent.
pid_t start(std::vector<std::string> command, const CaptureFile& out, const CaptureFile& err) {
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  std::array<int, 2> failure{};
  const pid_t parent = getpid();
  if (pipe2(failure.data(), O_CLOEXEC) != 0) throw FileError(command[0], std::strerror(errno));
  const pid_t process = fork();
  if (process == 0)
    become_program(arguments.data(), fileno(out.stream()), fileno(err.stream()), failure[1], parent);
  const int error = process < 0 ? errno : 0;
  close(failure[1]);
  const int start_error = process < 0 ? error : error_of_start(failure[0]);
  close(failure[0]);
  if (start_error == 0) return process;
  if (process > 0) waitpid(process, nullptr, 0);
  throw FileError(command[0], std::strerror(start_error));
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
