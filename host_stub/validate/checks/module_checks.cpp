// Checks the module's file and how it is loaded, initialised and unloaded.
#include <burin/base/stopwatch.h>
#include <burin/host/plugin/module.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <set>
#include <string_view>
#include <thread>

#include "validate/probe/elf.h"
#include "validate/probe/plugin.h"
#include "validate/probe/process_state.h"
#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

namespace fs = std::filesystem;

void check_loads(const Subject& subject) {
  require(subject.module.extension() == ".burin", "is not named NAME.burin, so hosts do not find it");
  try {
    const Plugin plugin(subject);
  } catch (const FileError& error) {
    throw Failed(error.what());
  }
}

void check_exports(const Subject& subject) {
  std::vector<std::string> others = read_elf(subject.module).exports;
  // Address sanitizers export a symbol of their own for each of the module's.
  std::erase_if(others, [](const std::string& name) {
    return name == BURIN_PLUGIN_SYMBOL || name == "__odr_asan." BURIN_PLUGIN_SYMBOL;
  });
  require(others.empty(), fmt::format("exports {} more: {}", others.size(), fmt::join(others, ", ")));
}

void check_libraries(const Subject& subject) {
  // Libraries that talk to screens, run interpreters or start threads by themselves.
  constexpr std::array<std::string_view, 9> forbidden = {
      "libX11", "libGL", "libpython", "libgtk", "libQt", "libwayland", "libcurl", "libtbb", "libgomp"};
  const std::vector<std::string> needed = read_elf(subject.module).needed;
  for (const std::string& library : needed)
    for (const std::string_view name : forbidden) require(!library.starts_with(name), "needs " + library);
  throw Told(needed.empty() ? "needs none" : fmt::format("needs {}", fmt::join(needed, ", ")));
}

/// The numbers of a version, "GLIBC_2.34" without "GLIBC_".
std::array<int, 3> numbers_of(std::string_view text) {
  std::array<int, 3> numbers{};
  for (int& number : numbers) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(std::min<std::size_t>(static_cast<std::size_t>(end - text.data()) + 1, text.size()));
  }
  return numbers;
}

/// The newest of the versions that begin with `name`, "GLIBC_2.34"; empty if there is none.
std::string newest(const std::vector<std::string>& versions, std::string_view name) {
  const auto numbers = [&](const std::string& version) {
    return numbers_of(std::string_view(version).substr(name.size()));
  };
  std::string newest;
  for (const std::string& version : versions)
    if (version.starts_with(name) && (newest.empty() || numbers(version) > numbers(newest))) newest = version;
  return newest;
}

void check_symbol_versions(const Subject& subject) {
  // Debian 12's.
  constexpr std::array<std::pair<std::string_view, std::array<int, 3>>, 3> floors = {
      {{"GLIBC_", {2, 36, 0}}, {"GLIBCXX_", {3, 4, 30}}, {"CXXABI_", {1, 3, 13}}}};
  const std::vector<std::string> versions = read_elf(subject.module).versions;
  std::vector<std::string> needed;
  for (const auto& [name, floor] : floors) {
    const std::string version = newest(versions, name);
    if (version.empty()) continue;
    require(numbers_of(std::string_view(version).substr(name.size())) <= floor,
            fmt::format("needs {}, newer than {}{}", version, name, fmt::join(floor, ".")));
    needed.push_back(version);
  }
  throw Told(needed.empty() ? "needs none" : fmt::format("needs {}", fmt::join(needed, ", ")));
}

void check_loads_twice(const Subject& subject) {
  Subject copy = subject;
  copy.module = subject.folder / "copy.burin";
  fs::copy_file(subject.module, copy.module, fs::copy_options::overwrite_existing);
  const Plugin first(subject), second(copy);
  require(first.brushes().size() == second.brushes().size(), "loaded twice, it has different brushes");
  const auto create = [](const Plugin& plugin) {
    for (const auto* brush : plugin.brushes()) require(brush && brush->id, "a brush without an id");
  };
  create(first);
  create(second);
}

void check_load_time(const Subject& subject) {
  const Stopwatch watch;
  const Plugin plugin(subject);
  const double ms = 1000 * watch.elapsed();
  require(ms <= 100, fmt::format("takes {:.0f} ms to load", ms));
}

void check_init_counted(const Subject& subject) {
  const Module module(subject.module);
  const burin_plugin_entry& entry = entry_of(module);
  for (int round = 0; round < 100; ++round) {
    for (int i = 0; i < 3; ++i)
      require(entry.init(subject.module.c_str(), nullptr) == BURIN_OK,
              fmt::format("init fails in round {}", round));
    for (int i = 0; i < 3; ++i) {
      require(entry.get_factory(BURIN_BRUSH_FACTORY),
              fmt::format("has no factory after {} of 3 deinits of round {}", i, round));
      entry.deinit();
    }
  }
}

void check_unknown_factory(const Subject& subject) {
  const Plugin plugin(subject);
  for (const char* id : {"burin.brush-factory/999", "", "org.example.factory"})
    require(!plugin.entry().get_factory(id), fmt::format("returns a factory for '{}'", id));
}

std::set<std::string> entries_of(const char* folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

/// Files of this process that are open; the one that listing them opens is not among them.
std::set<std::string> open_files() {
  std::set<std::string> files;
  for (const std::string& name : entries_of("/proc/self/fd")) {
    std::error_code error;
    const fs::path file = fs::read_symlink("/proc/self/fd/" + name, error);
    if (!error && !file.string().ends_with("/fd")) files.insert(name + " " + file.string());
  }
  return files;
}

/// Draws a stroke with each brush that can, since some start threads and open files only then.
void draw_once(const Subject& subject) {
  try {
    each_brush(subject, [&](const Plugin& plugin, const burin_brush_descriptor& descriptor) {
      ProbeBrush brush(plugin, descriptor, subject);
      ProbeStroke(brush).evaluate(random_nodes(300, subject.seed));
    });
  } catch (const Error&) {
    // Other checks tell why it does not draw.
  }
}

/// Whether there are threads besides these. The system lists one for a moment after it was joined.
bool has_other_threads(const std::set<std::string>& known) {
  const auto others = [&known] { return !std::ranges::includes(known, entries_of("/proc/self/task")); };
  for (int look = 0; look < 50 && others(); ++look)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return others();
}

/// Whether the system has the module still in memory, though nobody has it loaded.
bool stays_loaded(const Subject& subject) {
  void* handle = dlopen(subject.module.c_str(), RTLD_NOW | RTLD_NOLOAD);
  if (handle) dlclose(handle);
  return handle != nullptr;
}

void check_unloads(const Subject& subject) {
  const auto handlers = signal_handlers();
  draw_once(subject);  // The host's services may start threads once, when they are first asked for.
  const auto threads = entries_of("/proc/self/task"), files = open_files();
  draw_once(subject);
  require(!has_other_threads(threads), "leaves a thread after its last deinit");
  require(open_files() == files, "leaves a file open after its last deinit");
  require(signal_handlers() == handlers, "leaves a signal handler after its last deinit");
  require(
      !stays_loaded(subject),
      "stays in memory after it was unloaded: it is linked with -z nodelete, or has unique symbols, which "
      "-fno-gnu-unique avoids");
}

constexpr Check module_list[] = {
    {"module.loads", 1, "plugin.h: a module is a shared library named NAME.burin that exports burin_plugin",
     "Loads and initialises the module with RTLD_NOW and RTLD_LOCAL.", check_loads},
    {"module.exports", 2, "plugin.h: it should export nothing else but weak symbols",
     "Reads the symbols that the file defines.", check_exports},
    {"module.libraries", 3,
     "plugin.h: it needs no library that talks to a screen or the network, runs an interpreter or keeps "
     "threads",
     "Looks for libraries of screens, networks, interpreters and threads.", check_libraries},
    {"module.symbol-versions", 2,
     "plugin.h: it needs no symbol newer than GLIBC_2.36, GLIBCXX_3.4.30 and CXXABI_1.3.13",
     "Reads the versions of symbols that the module needs.", check_symbol_versions},
    {"module.loads-twice", 3, "plugin.h: a module may be in a process twice",
     "Loads a copy of the file beside it.", check_loads_twice},
    {"module.init-counted", 1, "plugin.h: each init is paired with one deinit; factories live until the last",
     "Initialises three times and undoes it, 100 times.", check_init_counted},
    {"module.unknown-factory", 1, "plugin.h: get_factory returns the factory with this id, or null",
     "Asks for factories that there are not.", check_unknown_factory},
    {"module.unloads", 3,
     "plugin.h: the last deinit leaves no thread, open file or signal handler, so that the module can be "
     "unloaded",
     "Compares threads, files and handlers before loading and after a stroke, and looks whether the module "
     "is gone.",
     check_unloads},
    {"module.load-time", 5, "plugin.h: loading and the first init take 100 ms at most",
     "Measures loading and init.", check_load_time},
};

}  // namespace

std::span<const Check> module_checks() { return module_list; }

}  // namespace burin::validate
