// Runs checks in forked processes, so that a plugin that crashes or hangs fails one check only. A child
// sends its verdict through a pipe and is killed at its time limit.
#include "validate/child_checks.h"

#include <burin/base/stopwatch.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <filesystem>

namespace burin::validate {
namespace {

/// A check that runs in a child.
struct Child {
  std::size_t index;  ///< of the check
  pid_t process;
  int pipe;          ///< from which its verdict is read
  std::string sent;  ///< a digit, the verdict, and the text
  Stopwatch watch;
};

/// The child: runs the check, sends the verdict and ends without any destructor of the parent's.
[[noreturn]] void be_child(Subject subject, const Check& check, int pipe, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  if (nowhere > STDERR_FILENO) close(nowhere);
  subject.folder /= check.name;
  std::filesystem::create_directories(subject.folder);
  const Result result = run_here(subject, check);
  const std::string text = std::to_string(static_cast<int>(result.verdict)) + result.text;
  const ssize_t written = write(pipe, text.data(), std::min<std::size_t>(text.size(), 4000));
  _exit(written > 0 ? 0 : 1);
}

Child start_child(const Subject& subject, const Check& check, std::size_t index) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error("no pipe can be made: " + std::string(std::strerror(errno)));
  const pid_t parent = getpid(), process = fork();
  if (process == 0) {
    close(ends[0]);
    be_child(subject, check, ends[1], parent);
  }
  close(ends[1]);
  if (process < 0) throw Error("no process can be started: " + std::string(std::strerror(errno)));
  return {index, process, ends[0], {}, {}};
}

/// Waits for a child that has closed its pipe, or is to be ended, and for what it started.
Result end_child(Child& child, const Check& check, bool late) {
  close(child.pipe);
  if (late) kill(child.process, SIGKILL);
  int status = 0;
  waitpid(child.process, &status, 0);
  kill(-child.process, SIGKILL);
  Result result{&check, Verdict::crash, {}, child.watch.elapsed()};
  if (late) {
    result.verdict = Verdict::timeout;
    result.text = fmt::format("did not end within {} seconds", time_limit);
  } else if (!child.sent.empty()) {
    result.verdict = static_cast<Verdict>(child.sent[0] - '0');
    result.text = child.sent.substr(1);
  } else if (WIFSIGNALED(status)) {
    result.text = strsignal(WTERMSIG(status));
  } else {
    result.text = fmt::format("ended the process with exit code {}", WEXITSTATUS(status));
  }
  return result;
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
  for (const Child& child : children) pipes.push_back({child.pipe, POLLIN, 0});
  poll(pipes.data(), pipes.size(), 50);
  std::vector<bool> ready;
  for (const pollfd& pipe : pipes) ready.push_back(pipe.revents != 0);
  return ready;
}

}  // namespace

std::vector<Result> run_in_children(const Subject& subject, std::span<const Check* const> checks, int jobs) {
  std::vector<Result> results(checks.size());
  std::vector<Child> running;
  for (std::size_t next = 0; next < checks.size() || !running.empty();) {
    while (next < checks.size() && running.size() < static_cast<std::size_t>(jobs)) {
      running.push_back(start_child(subject, *checks[next], next));
      ++next;
    }
    const std::vector<bool> ready = wait_for(running);
    std::vector<Child> still;
    for (std::size_t i = 0; i < running.size(); ++i) {
      Child& child = running[i];
      const bool late = child.watch.elapsed() > time_limit;
      if ((ready[i] && read_child(child)) || late)
        results[child.index] = end_child(child, *checks[child.index], late);
      else
        still.push_back(std::move(child));
    }
    running = std::move(still);
  }
  return results;
}

}  // namespace burin::validate
