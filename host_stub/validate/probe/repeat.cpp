// Runs work in a forked process, whose memory starts as this one's. The result comes back through a pipe.
#include "validate/probe/repeat.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>

namespace burin::validate {
namespace {

/// How a process ended that could tell.
constexpr int whole = 0, failed = 1, skipped = 3;

[[noreturn]] void send(int pipe, const std::string& text, int end) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t bytes = write(pipe, text.data() + sent, text.size() - sent);
    if (bytes <= 0) _exit(failed);
    sent += static_cast<std::size_t>(bytes);
  }
  _exit(end);
}

[[noreturn]] void work_and_send(int pipe, const std::function<std::string()>& work) {
  try {
    send(pipe, work(), whole);
  } catch (const Skipped& reason) {
    send(pipe, reason.what(), skipped);
  } catch (const std::exception& error) {
    send(pipe, error.what(), failed);
  }
}

}  // namespace

std::string in_process(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  require(pipe(ends.data()) == 0, "no pipe can be made");
  const pid_t parent = getpid(), process = fork();
  if (process == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(failed);
    work_and_send(ends[1], work);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t bytes; (bytes = read(ends[0], part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(bytes));
  close(ends[0]);
  int status = 0;
  waitpid(process, &status, 0);
  const int end = process > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (end == skipped) throw Skipped(text);
  if (end == failed && !text.empty()) throw Failed(text);
  if (end != whole) throw Crashed("a second process crashes");
  return text;
}

}  // namespace burin::validate
