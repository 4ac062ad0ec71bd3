// Looks at a module's file ten times a second. A changed file is whole when the last table that its ELF
// header names lies within it.
#include "watch/module_watch.h"

#include <burin/base/stopwatch.h>

#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>

namespace burin {
namespace fs = std::filesystem;

namespace {

constexpr auto between_looks = std::chrono::milliseconds(100);
constexpr double patience = 5;  ///< seconds without a change, after which half a library is taken as it is

/// The part of an ELF file's header that tells where its last table ends; see elf(5).
struct ElfHeader {
  std::array<char, 40> before;
  std::uint64_t sections;  ///< where the table of sections begins, bytes
  std::array<char, 10> between;
  std::uint16_t section_bytes, section_count, names;
};
static_assert(sizeof(ElfHeader) == 64);

/// Whether a file ends where its header says, if it is a library of this kind of system.
bool is_whole(const fs::path& module, std::uintmax_t size) {
  std::ifstream file(module, std::ios::binary);
  ElfHeader header{};
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  const bool nothing_yet = !file || header.before[0] == 0;
  if (nothing_yet) return false;
  if (std::memcmp(header.before.data(), "\177ELF", 4) != 0) return true;
  const std::uint64_t tables = std::uint64_t{header.section_bytes} * header.section_count;
  return header.sections <= size && tables <= size - header.sections;
}

}  // namespace

ModuleWatch::ModuleWatch(fs::path module) : module_(std::move(module)), seen_(look()) {}

std::optional<ModuleWatch::State> ModuleWatch::look() const {
  std::error_code time_error, size_error;
  const State state{fs::last_write_time(module_, time_error), fs::file_size(module_, size_error)};
  return time_error || size_error ? std::nullopt : std::optional(state);
}

void ModuleWatch::wait() {
  Stopwatch since_change;
  for (std::optional<State> last = seen_;;) {
    std::this_thread::sleep_for(between_looks);
    const std::optional<State> now = look();
    if (now != last) since_change = {};
    const bool changed = now && now != seen_, still = now == last;
    last = now;
    if (!changed || !still) continue;
    if (!is_whole(module_, now->size) && since_change.elapsed() < patience) continue;
    seen_ = now;
    return;
  }
}

}  // namespace burin
