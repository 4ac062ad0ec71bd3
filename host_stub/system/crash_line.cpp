// The handler only calls what POSIX allows in signal handlers: it neither allocates nor locks.
#include "system/crash_line.h"

#include <burin/deform/evaluate/plugin_call.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstring>

namespace burin {
namespace {

struct Crash {
  int signal;
  const char* name;
  struct sigaction before;
};

std::array<Crash, 5> crashes = {{{SIGSEGV, "segmentation fault", {}},
                                 {SIGBUS, "bus error", {}},
                                 {SIGFPE, "arithmetic error", {}},
                                 {SIGILL, "illegal instruction", {}},
                                 {SIGABRT, "abort", {}}}};

/// A line of fixed room; what exceeds it is cut.
class Line {
 public:
  void add(const char* text) {
    const std::size_t length = std::min(std::strlen(text), text_.size() - size_);
    std::memcpy(text_.data() + size_, text, length);
    size_ += length;
  }

  void write_to_stderr() const {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text_.data(), size_);
  }

 private:
  std::array<char, 1000> text_{};
  std::size_t size_ = 0;
};

void write_crash(const RunningPlugin& plugin, const char* signal) {
  Line line;
  for (const char* text : {"burin: ", plugin.kind, " ", plugin.name, " crashed: ", signal, "\n"})
    line.add(text);
  line.write_to_stderr();
}

void handle(int signal, siginfo_t* info, void*) {
  for (const Crash& crash : crashes) {
    if (crash.signal != signal) continue;
    if (const RunningPlugin plugin = PluginCall::running(); plugin.name) write_crash(plugin, crash.name);
    sigaction(signal, &crash.before, nullptr);
  }
  // A fault occurs again as soon as the handler returns; a signal that was sent does not.
  if (info->si_code <= 0) raise(signal);
}

/// A stack of the handler's own for this thread, since an overflow of its stack leaves none.
void use_stack_of_handler() {
  static std::array<char, 65536> memory;
  stack_t stack{};
  stack.ss_sp = memory.data();
  stack.ss_size = memory.size();
  sigaltstack(&stack, nullptr);
}

}  // namespace

void name_plugins_that_crash() {
  use_stack_of_handler();
  struct sigaction action {};
  action.sa_sigaction = handle;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (Crash& crash : crashes) sigaction(crash.signal, &action, &crash.before);
}

}  // namespace burin
