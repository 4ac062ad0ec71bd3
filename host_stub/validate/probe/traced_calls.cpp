// Watches a module's calls: for the time of the work, entries of its global offset table lead to functions
// that count and then call the real ones. A filter of system calls (seccomp) stops the rest.
#include "validate/probe/traced_calls.h"

#include <dlfcn.h>
#include <elf.h>
#include <execinfo.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "validate/probe/check.h"

namespace burin::validate {
namespace {

/// The calls of one function.
struct Calls {
  std::atomic<int> count{0};
  std::array<void*, 16> stack{};  ///< return addresses of the first call
  int depth = 0;
};
std::array<Calls, 7> calls;

void note(std::size_t function) {
  Calls& noted = calls[function];
  if (++noted.count == 1) noted.depth = backtrace(noted.stack.data(), static_cast<int>(noted.stack.size()));
}

void* count_malloc(std::size_t size) { return note(0), std::malloc(size); }
void* count_calloc(std::size_t count, std::size_t size) { return note(1), std::calloc(count, size); }
void* count_realloc(void* old, std::size_t size) { return note(2), std::realloc(old, size); }
void* count_new(std::size_t size) { return note(3), ::operator new(size); }
void* count_new_array(std::size_t size) { return note(4), ::operator new[](size); }
int count_lock(pthread_mutex_t* mutex) { return note(5), pthread_mutex_lock(mutex); }
std::FILE* count_fopen(const char* path, const char* mode) { return note(6), std::fopen(path, mode); }

struct Traced {
  const char* symbol;
  void* replacement;
  const char* name;
};

/// In the order of `calls`.
std::array<Traced, 7> traced() {
  return {{{"malloc", reinterpret_cast<void*>(count_malloc), "malloc"},
           {"calloc", reinterpret_cast<void*>(count_calloc), "calloc"},
           {"realloc", reinterpret_cast<void*>(count_realloc), "realloc"},
           {"_Znwm", reinterpret_cast<void*>(count_new), "operator new"},
           {"_Znam", reinterpret_cast<void*>(count_new_array), "operator new[]"},
           {"pthread_mutex_lock", reinterpret_cast<void*>(count_lock), "pthread_mutex_lock"},
           {"fopen", reinterpret_cast<void*>(count_fopen), "fopen"}}};
}

/// A slot of the module's table that holds the address of a traced function.
struct Slot {
  void** place;
  void* original;
  void* replacement;
};

void set(const Slot& slot, void* value) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  auto* start = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(slot.place) & ~(page - 1));
  require(mprotect(start, page, PROT_READ | PROT_WRITE) == 0, "its table of addresses cannot be changed");
  *slot.place = value;
}

/// The dynamic section of the module that holds `address`: numbers by their tags.
std::array<std::uintptr_t, 40> dynamic_of(const void* address, std::uintptr_t& base) {
  Dl_info info{};
  link_map* map = nullptr;
  require(dladdr1(address, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0,
          "its place is unknown");
  std::array<std::uintptr_t, 40> numbers{};
  for (const ElfW(Dyn)* entry = map->l_ld; entry->d_tag != DT_NULL; ++entry)
    if (entry->d_tag > 0 && entry->d_tag < 40)
      numbers[static_cast<std::size_t>(entry->d_tag)] = entry->d_un.d_ptr;
  base = map->l_addr;
  return numbers;
}

std::vector<Slot> slots_of(const void* address) {
  std::uintptr_t base = 0;
  const auto dynamic = dynamic_of(address, base);
  const auto* symbols = reinterpret_cast<const ElfW(Sym)*>(dynamic[DT_SYMTAB]);
  const auto* names = reinterpret_cast<const char*>(dynamic[DT_STRTAB]);
  std::vector<Slot> slots;
  const auto collect = [&](std::uintptr_t table, std::uintptr_t bytes) {
    const auto* entries = reinterpret_cast<const ElfW(Rela)*>(table);
    for (std::size_t i = 0; i < bytes / sizeof *entries; ++i) {
      const char* name = names + symbols[ELF64_R_SYM(entries[i].r_info)].st_name;
      auto* place = reinterpret_cast<void**>(base + entries[i].r_offset);
      for (const Traced& function : traced())
        if (std::strcmp(name, function.symbol) == 0) slots.push_back({place, *place, function.replacement});
    }
  };
  collect(dynamic[DT_RELA], dynamic[DT_RELASZ]);
  collect(dynamic[DT_JMPREL], dynamic[DT_PLTRELSZ]);
  return slots;
}

/// The places of a stack that lie in the module: "0x1234 < 0x1400", for addr2line.
std::string places_in(const Dl_info& module, const Calls& noted) {
  std::string places;
  for (int i = 0; i < noted.depth; ++i) {
    Dl_info info{};
    const char* returns_to = static_cast<const char*>(noted.stack[static_cast<std::size_t>(i)]);
    if (dladdr(returns_to, &info) == 0 || info.dli_fbase != module.dli_fbase) continue;
    // One byte before the place that the call returns to is the call.
    const auto offset = returns_to - 1 - static_cast<const char*>(module.dli_fbase);
    places += fmt::format("{}{:#x}", places.empty() ? "" : " < ", offset);
  }
  return places;
}

}  // namespace

std::vector<std::string> calls_during(const burin_plugin_entry& entry, const std::function<void()>& work) {
  const std::vector<Slot> slots = slots_of(&entry);
  Dl_info module{};
  dladdr(&entry, &module);
  for (Calls& noted : calls) {
    noted.count = 0;
    noted.depth = backtrace(noted.stack.data(), 1);  // The first call of all loads what it needs.
  }
  for (const Slot& slot : slots) set(slot, slot.replacement);
  work();
  for (const Slot& slot : slots) set(slot, slot.original);
  std::vector<std::string> called;
  const auto functions = traced();
  for (std::size_t i = 0; i < functions.size(); ++i)
    if (calls[i].count > 0)
      called.push_back(fmt::format("{} {} times, first at {}", functions[i].name, calls[i].count.load(),
                                   places_in(module, calls[i])));
  return called;
}

void without_system_calls(const std::function<void()>& work) {
#if defined(__x86_64__)
  constexpr std::array<unsigned, 12> refused = {SYS_open,  SYS_openat, SYS_creat,  SYS_read,
                                                SYS_write, SYS_writev, SYS_socket, SYS_connect,
                                                SYS_clone, SYS_fork,   SYS_execve, SYS_nanosleep};
  std::vector<sock_filter> program = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const unsigned number : refused) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, number, 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0)
    throw Skipped("the system does not let a process refuse system calls");
  work();
#else
  throw Skipped("system calls are refused on x86-64 only");
#endif
}

}  // namespace burin::validate
