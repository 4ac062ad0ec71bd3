// Finds the running program by Linux's /proc.
#include <burin/base/program_file.h>

namespace burin {

namespace fs = std::filesystem;

fs::path program_file() { return fs::read_symlink("/proc/self/exe"); }

fs::path beside_program(const char* name) {
  const fs::path folder = program_file().parent_path();
  fs::path beside = folder / name;
  return fs::exists(beside) ? beside : folder.parent_path() / "lib" / "burin" / name;
}

}  // namespace burin
