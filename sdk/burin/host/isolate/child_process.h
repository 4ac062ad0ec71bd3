#pragma once
#include <burin/host/isolate/channel.h>
#include <sys/types.h>

#include <filesystem>
#include <span>
#include <string>

namespace burin::isolate {

/// A program that was started, in a process group of its own. The destructor kills the group and takes the
/// process off the system's table, so that no zombie is left. One thread at a time, but running().
class ChildProcess {
 public:
  /// The descriptors become number 3 and on in the program, which has no others but the standard streams:
  /// an empty input and, for output, this process's stderr. Throws FileError if it cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::string& argument,
               std::span<const int> descriptors);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// Becomes readable, for poll(), when the process has ended.
  int descriptor() const { return pidfd_.number(); }
  bool running() const;

  /// Waits for the end; returns whether it came in time.
  bool wait(Clock::time_point deadline) const;

  /// Interrupts one of its threads by a signal; of the first, `thread` is 0.
  void interrupt(pid_t thread, int signal) const;

  /// How it ended, killed now unless it had: "exited with status 3", "was killed by signal 9".
  std::string end();

 private:
  pid_t process_ = -1;
  Descriptor pidfd_;
  std::string ending_;  ///< empty: not waited for yet
};

}  // namespace burin::isolate
