// Looks at a module's file ten times a second. A changed file is whole when it holds what its ELF header
// names.
#include "watch/module_watch.h"

#include <burin/base/stopwatch.h>
#include <burin/host/plugin/module_file.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace burin {
namespace fs = std::filesystem;

namespace {

constexpr auto between_looks = std::chrono::milliseconds(100);
constexpr double patience = 5;  ///< seconds without a change, after which half a library is taken as it is

/// Whether a file ends where its header says, if it is a library of this kind of system.
bool is_whole(const fs::path& module) {
  std::ifstream file(module, std::ios::binary);
  const int first = file.get();
  const bool nothing_yet = first == std::ifstream::traits_type::eof() || first == 0;
  return !nothing_yet && !is_cut_off(module);
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
    if (!is_whole(module_) && since_change.elapsed() < patience) continue;
    seen_ = now;
    return;
  }
}

}  // namespace burin
