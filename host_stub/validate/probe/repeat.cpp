// Runs work in a forked process, whose memory starts as this one's. The result comes back through a pipe, and
// how the work ended through shared memory: a plugin may end the process with any exit code.
#include "validate/probe/repeat.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>

#include "validate/probe/shared.h"

namespace burin::validate {
namespace {

/// How work came to its end. A process that ended before has written none of these.
enum class End { none, whole, failed, skipped };

void send(int pipe, const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t bytes = write(pipe, text.data() + sent, text.size() - sent);
    if (bytes <= 0) _exit(1);
    sent += static_cast<std::size_t>(bytes);
  }
}

[[noreturn]] void work_and_send(int pipe, End& end, const std::function<std::string()>& work) {
  try {
    send(pipe, work());
    end = End::whole;
  } catch (const Skipped& reason) {
    send(pipe, reason.what());
    end = End::skipped;
  } catch (const std::exception& error) {
    send(pipe, error.what());
    end = End::failed;
  }
  _exit(0);
}

}  // namespace

std::string in_process(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  require(pipe(ends.data()) == 0, "no pipe can be made");
  const Shared<End> end;
  const pid_t parent = getpid(), process = fork();
  if (process == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    work_and_send(ends[1], *end, work);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t bytes; (bytes = read(ends[0], part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(bytes));
  close(ends[0]);
  waitpid(process, nullptr, 0);
  if (*end == End::none) throw Crashed("a second process crashes");
  if (*end == End::skipped) throw Skipped(text);
  if (*end == End::failed) throw Failed(text);
  return text;
}

}  // namespace burin::validate
