// Asks Linux about this process. Its memory and its start are read from /proc; its limit of memory is the
// least of the machine's, its control group's and its own.
#include "system/platform.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace burin {
namespace {

/// The number in a line "NAME: 123" or "NAME: 123 kB" in /proc/self/status.
std::size_t process_status(std::string_view name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(name, 0) == 0) return std::stoull(line.substr(name.size() + 1));
  }
  return 0;
}

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace

// getrusage() is not used, since its maximum survives exec() and may be that of the program that started this
// one.
std::size_t peak_memory() { return 1024 * process_status("VmHWM"); }

std::size_t resident_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  return 1024 * process_status("VmRSS");
}

std::size_t memory_limit() {
  const long pages = sysconf(_SC_PHYS_PAGES), bytes_per_page = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || bytes_per_page <= 0) return 0;
  std::size_t limit = static_cast<std::size_t>(pages) * static_cast<std::size_t>(bytes_per_page),
              of_container = 0;
  std::ifstream container("/sys/fs/cgroup/memory.max");
  if (container >> of_container) limit = std::min(limit, of_container);
  rlimit of_process{};
  if (getrlimit(RLIMIT_AS, &of_process) == 0 && of_process.rlim_cur != RLIM_INFINITY)
    limit = std::min(limit, static_cast<std::size_t>(of_process.rlim_cur));
  return limit;
}

double seconds_since_process_start() {
  std::ifstream stat("/proc/self/stat");
  std::string line;
  std::getline(stat, line);
  // The name of the program may contain blanks, so fields are counted from its closing parenthesis.
  std::istringstream fields(line.substr(line.rfind(')') + 1));
  std::string skipped;
  for (int field = 3; field < 22; ++field) fields >> skipped;
  double start_ticks = 0;
  fields >> start_ticks;
  return seconds_of(CLOCK_BOOTTIME) - start_ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

bool is_debugged() { return process_status("TracerPid") != 0; }

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }

std::FILE* divert_standard_output() {
  std::fflush(stdout);
  const int before = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  std::FILE* results = before < 0 ? nullptr : fdopen(before, "w");
  if (results) dup2(STDERR_FILENO, STDOUT_FILENO);
  return results;
}

}  // namespace burin
