// Writes seeds for libFuzzer: burin_fuzz_seeds READER FOLDER. Without arguments it names the readers.
#include <cstdio>

#include "readers.h"

int main(int count, char** arguments) {
  if (count != 3) {
    for (const burin::fuzz::Reader& reader : burin::fuzz::readers()) std::puts(reader.name);
    return 0;
  }
  const burin::fuzz::Reader* reader = burin::fuzz::reader_named(arguments[1]);
  if (!reader) return std::fprintf(stderr, "no reader '%s'\n", arguments[1]), 2;
  burin::fuzz::write_seeds(*reader, arguments[2]);
}
