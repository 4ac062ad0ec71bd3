// Starts programs by posix_spawn(), which is safe in a process with many threads: nothing of this process
// runs in the child before the program does. A pidfd names the process even after its number has gone to
// another.
#if defined(__linux__)
#include <burin/host/isolate/child_process.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

namespace burin::isolate {
namespace {

/// What posix_spawn() does in the child before the program.
class SpawnActions {
 public:
  explicit SpawnActions(std::span<const int> descriptors) {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (fcntl(STDERR_FILENO, F_GETFD) < 0)
      posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files_, STDERR_FILENO, STDOUT_FILENO);
    // Copies above all targets, so that none is overwritten before it is copied.
    constexpr int first = 3;
    const int above = first + static_cast<int>(descriptors.size());
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
      copies_.emplace_back(fcntl(descriptors[i], F_DUPFD_CLOEXEC, above));
      posix_spawn_file_actions_adddup2(&files_, copies_.back().number(), first + static_cast<int>(i));
    }
    posix_spawn_file_actions_addclosefrom_np(&files_, above);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_,
                             POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  int spawn(pid_t& process, const std::string& program, const std::string& argument) const {
    std::string name = program, text = argument;
    const std::array<char*, 3> arguments{name.data(), text.data(), nullptr};
    return posix_spawn(&process, program.c_str(), &files_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
  std::vector<Descriptor> copies_;
};

std::string ending_of(const siginfo_t& info) {
  if (info.si_code == CLD_EXITED) return fmt::format("exited with status {}", info.si_status);
  return fmt::format("was killed by signal {} ({})", info.si_status, strsignal(info.si_status));
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::string& argument,
                           std::span<const int> descriptors) {
  if (const int error = SpawnActions(descriptors).spawn(process_, program.string(), argument))
    throw FileError(program.string(), fmt::format("cannot be started: {}", std::strerror(error)));
  pidfd_ = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, process_, 0)));
  if (pidfd_.number() >= 0) return;
  const int error = errno;
  end();
  throw FileError(program.string(), fmt::format("cannot be watched: {}", std::strerror(error)));
}

ChildProcess::~ChildProcess() { end(); }

bool ChildProcess::running() const {
  pollfd ended{pidfd_.number(), POLLIN, 0};
  return ending_.empty() && poll(&ended, 1, 0) == 0;
}

bool ChildProcess::wait(Clock::time_point deadline) const {
  pollfd ended{pidfd_.number(), POLLIN, 0};
  while (poll(&ended, 1, poll_time(deadline)) <= 0)
    if (Clock::now() >= deadline) return false;
  return true;
}

void ChildProcess::interrupt(pid_t thread, int signal) const {
  syscall(SYS_tgkill, process_, thread != 0 ? thread : process_, signal);
}

std::string ChildProcess::end() {
  if (!ending_.empty()) return ending_;
  // The group may be there without its leader, which keeps the number until it is waited for.
  ::kill(-process_, SIGKILL);
  ::kill(process_, SIGKILL);
  siginfo_t info{};
  int result = 0;
  while ((result = waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED)) < 0 && errno == EINTR) {
  }
  // An application may wait for all of its children, or have the system do it.
  ending_ = result == 0 ? ending_of(info) : "ended";
  return ending_;
}

}  // namespace burin::isolate
#endif
