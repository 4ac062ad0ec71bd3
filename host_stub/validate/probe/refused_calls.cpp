// A filter of system calls (seccomp) turns those that are refused into a signal, whose handler notes the call
// where this process can read it and ends the copy.
#include "validate/probe/refused_calls.h"

#include "validate/probe/check.h"

#if defined(__x86_64__)

#include <fmt/format.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <vector>

#include "validate/probe/repeat.h"
#include "validate/probe/shared.h"
#include "validate/probe/stack_places.h"

namespace burin::validate {
namespace {

struct Refused {
  long number;
  const char* name;
};

constexpr std::array<Refused, 28> refused = {
    {{SYS_open, "open"},       {SYS_openat, "openat"},       {SYS_creat, "creat"},
     {SYS_read, "read"},       {SYS_pread64, "pread"},       {SYS_readv, "readv"},
     {SYS_write, "write"},     {SYS_pwrite64, "pwrite"},     {SYS_writev, "writev"},
     {SYS_stat, "stat"},       {SYS_fstat, "fstat"},         {SYS_newfstatat, "fstatat"},
     {SYS_access, "access"},   {SYS_unlink, "unlink"},       {SYS_rename, "rename"},
     {SYS_mkdir, "mkdir"},     {SYS_getdents64, "getdents"}, {SYS_socket, "socket"},
     {SYS_connect, "connect"}, {SYS_sendto, "sendto"},       {SYS_clone, "clone"},
     {SYS_clone3, "clone"},    {SYS_fork, "fork"},           {SYS_vfork, "vfork"},
     {SYS_execve, "execve"},   {SYS_nanosleep, "nanosleep"}, {SYS_clock_nanosleep, "clock_nanosleep"},
     {SYS_poll, "poll"}}};

/// The call that ended the copy of this process, in memory that both have.
struct Noted {
  int number = -1;
  Stack stack;
};
Noted* noted = nullptr;

void note_and_end(int, siginfo_t* info, void*) {
  noted->number = info->si_syscall;
  noted->stack = stack_here();
  _exit(0);
}

void refuse() {
  struct sigaction action {};
  action.sa_sigaction = note_and_end;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
  std::vector<sock_filter> program = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const Refused& call : refused) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call.number), 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0)
    throw Skipped("the system does not let a process refuse system calls");
}

const char* name_of_call(int number) {
  for (const Refused& call : refused)
    if (call.number == number) return call.name;
  return "a system call";
}

}  // namespace

std::string refused_call(const void* address, const std::function<void()>& work) {
  const Shared<Noted> shared;
  noted = &*shared;
  (void)stack_here();  // The first stack of all loads what it needs.
  try {
    in_process([&]() -> std::string {
      refuse();
      work();
      return {};
    });
    return {};
  } catch (const Crashed&) {
    if (noted->number < 0) throw;
  }
  const std::string places = places_in_module(noted->stack, address);
  return fmt::format("{}{}{}", name_of_call(noted->number), places.empty() ? "" : " at ", places);
}

}  // namespace burin::validate

#else

namespace burin::validate {

std::string refused_call(const void*, const std::function<void()>&) {
  throw Skipped("system calls are refused on x86-64 only");
}

}  // namespace burin::validate

#endif
