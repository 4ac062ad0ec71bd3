// Finds the running program by Linux's /proc, and the shared library that has this code by the C library.
#include <burin/base/program_file.h>

#if defined(__linux__)
#include <dlfcn.h>
#include <link.h>
#endif

namespace burin {

namespace fs = std::filesystem;

fs::path program_file() { return fs::read_symlink("/proc/self/exe"); }

namespace {

/// The shared library that this code is in, or else the program, which has no name among those loaded.
fs::path own_file() {
#if defined(__linux__)
  Dl_info info;
  void* object = nullptr;
  if (dladdr1(reinterpret_cast<void*>(&own_file), &info, &object, RTLD_DL_LINKMAP) != 0)
    if (const char* name = static_cast<link_map*>(object)->l_name; *name) return fs::canonical(name);
#endif
  return program_file();
}

}  // namespace

fs::path beside_own_file(const char* name) {
  const fs::path folder = own_file().parent_path();
  fs::path beside = folder / name;
  return fs::exists(beside) ? beside : folder.parent_path() / "lib" / "burin" / name;
}

}  // namespace burin
