// The readers under libFuzzer [llvm.org/docs/LibFuzzer]: the variable BURIN_FUZZ_READER names the one. They
// read files, so each input becomes one, in the memory that Linux has as a folder.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "readers.h"

namespace {

namespace fs = std::filesystem;

const burin::fuzz::Reader& chosen_reader() {
  const char* name = std::getenv("BURIN_FUZZ_READER");
  const burin::fuzz::Reader* reader = burin::fuzz::reader_named(name ? name : "");
  if (reader) return *reader;
  std::fputs("BURIN_FUZZ_READER names none of the readers\n", stderr);
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const burin::fuzz::Reader& reader = chosen_reader();
  static const fs::path file =
      fs::path("/dev/shm") / ("burin-fuzz-" + std::to_string(getpid()) + reader.extension);
  static const int removes = std::atexit([] { fs::remove(file); });
  static_cast<void>(removes);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  burin::fuzz::accepts_however_read(reader, file);
  return 0;
}
