// Tells where a brush crashed: of the calls on the stack the innermost in the brush's module, by its place in
// the file and its function. The handler first writes what needs neither memory nor locks, then tries to make
// the function's name readable, which may crash or wait for ever; the host waits for that a moment only.
#include "crash_handler.h"

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "symbol_table.h"

namespace burin::process {
namespace {

using isolate::CrashRecord;

/// What the handlers need, which nothing frees.
struct Told {
  CrashRecord* record = nullptr;
  char module[4096] = "";  ///< canonical path
  std::unique_ptr<SymbolTable> symbols;
  std::atomic<bool> exit_expected = false;
};

Told& told() {
  static Told* const told = new Told;
  return *told;
}

template <std::size_t size>
void copy_text(char (&to)[size], const char* text) {
  const std::size_t length = std::min(std::strlen(text), size - 1);
  std::memcpy(to, text, length);
  to[length] = '\0';
}

const char* file_name(const char* path) {
  const char* slash = std::strrchr(path, '/');
  return slash ? slash + 1 : path;
}

/// Writes "NAME+0xOFFSET".
void write_place(CrashRecord& record, const char* name, std::uint64_t offset) {
  char digits[20];
  std::size_t count = 0;
  do {
    digits[count++] = "0123456789abcdef"[offset % 16];
    offset /= 16;
  } while (offset != 0);
  const std::size_t room = sizeof record.place - count - 4;
  const std::size_t length = std::min(std::strlen(name), room);
  std::memcpy(record.place, name, length);
  std::memcpy(record.place + length, "+0x", 3);
  for (std::size_t i = 0; i < count; ++i) record.place[length + 3 + i] = digits[count - 1 - i];
  record.place[length + 3 + count] = '\0';
}

/// Whether this is the brush's module.
bool is_module(const char* path) { return path && std::strcmp(path, told().module) == 0; }

/// Writes the place of an address; returns whether it is in the brush's module, or `anywhere`.
bool write_address(CrashRecord& record, const void* address, bool anywhere) {
  Dl_info info;
  if (dladdr(address, &info) == 0 || !info.dli_fname) return false;
  const bool in_module = is_module(info.dli_fname);
  if (!in_module && !anywhere) return false;
  const std::uint64_t offset =
      reinterpret_cast<std::uintptr_t>(address) - reinterpret_cast<std::uintptr_t>(info.dli_fbase);
  write_place(record, file_name(info.dli_fname), offset);
  const char* name = in_module && told().symbols ? told().symbols->find(offset) : nullptr;
  if (!name) name = info.dli_sname;
  if (name) copy_text(record.function, name);
  return true;
}

/// Writes the innermost call in the module, else where the instruction is.
void write_where(CrashRecord& record, const void* instruction) {
  if (instruction && write_address(record, instruction, false)) return;
  std::array<void*, 64> frames{};
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  for (int i = 0; i < count; ++i) {
    // Frames are return addresses, which may be those of the function behind.
    const char* call = static_cast<const char*>(frames[static_cast<std::size_t>(i)]) - 1;
    if (write_address(record, call, false)) return;
  }
  if (instruction) write_address(record, instruction, true);
}

/// Writes a function's name without its parameters and without what all names of a source share.
void write_readable(CrashRecord& record, const char* name) {
  constexpr std::string_view unnamed = "(anonymous namespace)::";
  std::string_view rest = name;
  std::size_t length = 0;
  while (!rest.empty() && length + 1 < sizeof record.readable) {
    if (rest.starts_with(unnamed)) {
      rest.remove_prefix(unnamed.size());
      continue;
    }
    if (rest.front() == '(') break;
    record.readable[length++] = rest.front();
    rest.remove_prefix(1);
  }
  record.readable[length] = '\0';
}

void tell(int signal, int code, const void* address, const void* instruction) {
  CrashRecord& record = *told().record;
  if (record.claimed.exchange(1) != 0) return;
  record.signal = signal;
  record.code = code;
  record.address = reinterpret_cast<std::uintptr_t>(address);
  write_where(record, instruction);
  record.told = 1;
  int status = 0;
  if (char* readable = abi::__cxa_demangle(record.function, nullptr, nullptr, &status))
    write_readable(record, readable);
  record.told = 2;
}

const void* instruction_of(void* context) {
#if defined(__x86_64__)
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  return reinterpret_cast<const void*>(static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP]);
#else
  (void)context;
  return nullptr;
#endif
}

void handle_crash(int signal, siginfo_t* info, void* context) {
  struct sigaction by_default {};
  by_default.sa_handler = SIG_DFL;
  sigaction(signal, &by_default, nullptr);
  tell(signal, info->si_code, info->si_addr, instruction_of(context));
  // A fault occurs again as soon as the handler returns; a signal that was sent does not.
  if (info->si_code <= 0) raise(signal);
}

void handle_question(int signal, siginfo_t* info, void* context) {
  tell(signal, info->si_code, nullptr, instruction_of(context));
}

void handle_exit(int status, void*) {
  if (told().exit_expected) return;
  tell(0, status, nullptr, nullptr);
  std::_Exit(status);
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void use_handler_stack() {
  constexpr std::size_t size = 256 << 10;
  stack_t stack{};
  stack.ss_sp = new char[size];
  stack.ss_size = size;
  sigaltstack(&stack, nullptr);
}

void tell_crashes(CrashRecord& record) {
  told().record = &record;
  use_handler_stack();
  // Its first call loads a library.
  std::array<void*, 1> frames{};
  backtrace(frames.data(), 1);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP})
    handle(signal, handle_crash);
  handle(SIGUSR2, handle_question);
  on_exit(handle_exit, nullptr);
}

void tell_functions_of(const std::filesystem::path& module) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(module, error);
  copy_text(told().module, whole.c_str());
  told().symbols = std::make_unique<SymbolTable>(whole);
}

void expect_exit() { told().exit_expected = true; }

}  // namespace burin::process
