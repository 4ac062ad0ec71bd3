// Watches calls that a module makes, itself or by the libraries that it uses: for the time of the work,
// entries of their global offset tables lead to functions that count and then call the real ones.
#include "validate/probe/traced_calls.h"

#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <string_view>

#include "validate/probe/check.h"
#include "validate/probe/stack_places.h"

namespace burin::validate {
namespace {

/// The calls of one function.
struct Calls {
  int count = 0;
  std::string first;  ///< the places that the first call came from
};
std::array<Calls, 13> calls;
std::mutex noting;
const void* traced_module = nullptr;  ///< an address in it
thread_local int nested = 0;          ///< functions that are counted and call each other

/// A call of a function, which counts if the module is on the stack. Calls within it do not.
class Call {
 public:
  explicit Call(std::size_t function) {
    if (++nested > 1) return;
    const std::string places = places_in_module(stack_here(), traced_module);
    if (places.empty()) return;
    const std::lock_guard guard(noting);
    if (++calls[function].count == 1) calls[function].first = places;
  }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;
  ~Call() { --nested; }
};

std::array<void*, 13> real{};  ///< the functions that are counted, in the order of `calls`

/// Calls the real function of this number and counts that.
template <std::size_t number, class Result, class... Arguments>
Result counted(Arguments... arguments) {
  const Call call(number);
  return reinterpret_cast<Result (*)(Arguments...)>(real[number])(arguments...);
}

struct Traced {
  const char* symbol;
  void* replacement;
  const char* name;
};

template <class Function>
void* address_of(Function* function) {
  return reinterpret_cast<void*>(function);
}

/// In the order of `calls`.
const std::array<Traced, 13>& traced() {
  using std::size_t;
  static const std::array<Traced, 13> functions = {
      {{"malloc", address_of(counted<0, void*, size_t>), "malloc"},
       {"calloc", address_of(counted<1, void*, size_t, size_t>), "calloc"},
       {"realloc", address_of(counted<2, void*, void*, size_t>), "realloc"},
       {"aligned_alloc", address_of(counted<3, void*, size_t, size_t>), "aligned_alloc"},
       {"posix_memalign", address_of(counted<4, int, void**, size_t, size_t>), "posix_memalign"},
       {"_Znwm", address_of(counted<5, void*, size_t>), "operator new"},
       {"_Znam", address_of(counted<6, void*, size_t>), "operator new[]"},
       {"_ZnwmSt11align_val_t", address_of(counted<7, void*, size_t, size_t>), "operator new, aligned,"},
       {"_ZnwmRKSt9nothrow_t", address_of(counted<8, void*, size_t, const void*>), "operator new, nothrow,"},
       {"pthread_mutex_lock", address_of(counted<9, int, void*>), "pthread_mutex_lock"},
       {"pthread_rwlock_rdlock", address_of(counted<10, int, void*>), "pthread_rwlock_rdlock"},
       {"pthread_rwlock_wrlock", address_of(counted<11, int, void*>), "pthread_rwlock_wrlock"},
       {"fopen", address_of(counted<12, void*, const char*, const char*>), "fopen"}}};
  return functions;
}

/// A slot of a table that holds the address of a traced function.
struct Slot {
  void** place;
  void* original;
  void* replacement;
};

void set(const Slot& slot, void* value) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  auto* start = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(slot.place) & ~(page - 1));
  require(mprotect(start, page, PROT_READ | PROT_WRITE) == 0, "a table of addresses cannot be changed");
  *slot.place = value;
}

/// Appends the slots of a library.
void collect_slots(const link_map& library, std::vector<Slot>& slots) {
  std::array<std::uintptr_t, 40> dynamic{};
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry)
    if (entry->d_tag > 0 && entry->d_tag < 40)
      dynamic[static_cast<std::size_t>(entry->d_tag)] = entry->d_un.d_ptr;
  const auto* symbols = reinterpret_cast<const ElfW(Sym)*>(dynamic[DT_SYMTAB]);
  const auto* names = reinterpret_cast<const char*>(dynamic[DT_STRTAB]);
  const auto collect = [&](std::uintptr_t table, std::uintptr_t bytes) {
    const auto* entries = reinterpret_cast<const ElfW(Rela)*>(table);
    for (std::size_t i = 0; i < bytes / sizeof *entries; ++i) {
      const std::string_view name = names + symbols[ELF64_R_SYM(entries[i].r_info)].st_name;
      if (name.empty()) continue;
      auto* place = reinterpret_cast<void**>(library.l_addr + entries[i].r_offset);
      for (const Traced& function : traced())
        if (name == function.symbol) slots.push_back({place, *place, function.replacement});
    }
  };
  collect(dynamic[DT_RELA], dynamic[DT_RELASZ]);
  collect(dynamic[DT_JMPREL], dynamic[DT_PLTRELSZ]);
}

/// The slots of all that is loaded but the loader and what sanitizers are made of.
std::vector<Slot> all_slots() {
  std::vector<Slot> slots;
  for (const link_map* library = _r_debug.r_map; library; library = library->l_next) {
    const std::string_view name = library->l_name;
    const auto has = [&](std::string_view part) { return name.find(part) != name.npos; };
    if (has("linux-vdso") || has("/ld-linux") || has("san.so")) continue;
    collect_slots(*library, slots);
  }
  return slots;
}

}  // namespace

void require_countable_memory() {
  Dl_info heap{}, library{};
  const bool found = dladdr(dlsym(RTLD_DEFAULT, "malloc"), &heap) != 0 &&
                     dladdr(dlsym(RTLD_DEFAULT, "gnu_get_libc_version"), &library) != 0;
  if (!found || heap.dli_fbase != library.dli_fbase)
    throw Skipped("malloc is replaced, by a sanitizer or a preloaded library");
}

std::vector<std::string> calls_during(const burin_plugin_entry& entry, const std::function<void()>& work) {
  traced_module = &entry;
  calls = {};
  for (std::size_t i = 0; i < real.size(); ++i) real[i] = dlsym(RTLD_DEFAULT, traced()[i].symbol);
  (void)places_in_module(stack_here(), &entry);  // The first stack of all loads what it needs.
  const std::vector<Slot> slots = all_slots();
  for (const Slot& slot : slots) set(slot, slot.replacement);
  work();
  for (const Slot& slot : slots) set(slot, slot.original);
  std::vector<std::string> called;
  for (std::size_t i = 0; i < calls.size(); ++i)
    if (calls[i].count > 0)
      called.push_back(
          fmt::format("{} {} times, first at {}", traced()[i].name, calls[i].count, calls[i].first));
  return called;
}

}  // namespace burin::validate
