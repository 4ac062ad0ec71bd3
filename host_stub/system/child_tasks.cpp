// Runs tasks in forked processes, whose texts come back through pipes.
#include "system/child_tasks.h"

#include <burin/base/error.h>
#include <burin/base/stopwatch.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace burin {
namespace {

using Task = std::function<std::string(std::size_t)>;

/// A task that runs in a child.
struct Child {
  std::size_t index;  ///< of the task
  pid_t process;
  int pipe;          ///< from which its text is read
  std::string sent;  ///< a byte, so that there is one, and the text
  Stopwatch watch;
};

/// Lets exit(), should the task call it, end the child at once with its code: destructors of the parent's
/// objects would wait for threads that a child does not have.
void end_at_exit() {
  on_exit([](int code, void*) { _exit(code); }, nullptr);
}

/// The child: does the task, sends its text and ends without any destructor of the parent's.
[[noreturn]] void be_child(std::size_t index, const Task& task, int pipe, pid_t parent) {
  setpgid(0, 0);
  end_at_exit();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  if (nowhere > STDERR_FILENO) close(nowhere);
  std::string text = " ";
  try {
    text += task(index);
  } catch (...) {
    _exit(1);
  }
  const ssize_t written = write(pipe, text.data(), std::min<std::size_t>(text.size(), 4001));
  _exit(written > 0 ? 0 : 1);
}

Child start_child(std::size_t index, const Task& task) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error("no pipe can be made: " + std::string(std::strerror(errno)));
  const pid_t parent = getpid(), process = fork();
  if (process == 0) {
    close(ends[0]);
    be_child(index, task, ends[1], parent);
  }
  close(ends[1]);
  if (process < 0) throw Error("no process can be started: " + std::string(std::strerror(errno)));
  return {index, process, ends[0], {}, {}};
}

/// Waits for a child that has closed its pipe, or is to be ended, and for what it started.
ChildResult end_child(Child& child, bool late, double limit) {
  using End = ChildResult::End;
  close(child.pipe);
  if (late) kill(child.process, SIGKILL);
  int status = 0;
  waitpid(child.process, &status, 0);
  kill(-child.process, SIGKILL);
  const double seconds = child.watch.elapsed();
  if (late) return {End::late, fmt::format("did not end within {} seconds", limit), seconds};
  if (!child.sent.empty()) return {End::whole, child.sent.substr(1), seconds};
  if (WIFSIGNALED(status)) return {End::crashed, strsignal(WTERMSIG(status)), seconds};
  return {End::crashed, fmt::format("ended the process with exit code {}", WEXITSTATUS(status)), seconds};
}

/// Reads what a child sent; returns whether it has closed its pipe.
bool read_child(Child& child) {
  std::array<char, 4096> part{};
  const ssize_t bytes = read(child.pipe, part.data(), part.size());
  if (bytes > 0) child.sent.append(part.data(), static_cast<std::size_t>(bytes));
  return bytes <= 0;
}

/// Waits until a child sends something or 50 ms pass; returns for each whether there is something to read.
std::vector<bool> wait_for(const std::vector<Child>& children) {
  std::vector<pollfd> pipes;
  pipes.reserve(children.size());
  for (const Child& child : children) pipes.push_back({child.pipe, POLLIN, 0});
  poll(pipes.data(), pipes.size(), 50);
  std::vector<bool> ready;
  ready.reserve(pipes.size());
  for (const pollfd& pipe : pipes) ready.push_back(pipe.revents != 0);
  return ready;
}

}  // namespace

std::vector<ChildResult> run_in_children(std::size_t count, int jobs, double limit, const Task& task) {
  std::vector<ChildResult> results(count);
  std::vector<Child> running;
  for (std::size_t next = 0; next < count || !running.empty();) {
    while (next < count && running.size() < static_cast<std::size_t>(jobs))
      running.push_back(start_child(next++, task));
    const std::vector<bool> ready = wait_for(running);
    std::vector<Child> still;
    for (std::size_t i = 0; i < running.size(); ++i) {
      Child& child = running[i];
      const bool late = child.watch.elapsed() > limit;
      if ((ready[i] && read_child(child)) || late)
        results[child.index] = end_child(child, late, limit);
      else
        still.push_back(std::move(child));
    }
    running = std::move(still);
  }
  return results;
}

}  // namespace burin
