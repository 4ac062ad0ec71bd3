#pragma once
#include <cstdint>
#include <filesystem>

namespace burin {

/// How a BrushLibrary runs brushes in processes of their own, so that one that crashes, hangs or allocates
/// without end costs a stroke and nothing else. Linux only. docs/isolation.md describes what follows.
///
/// Seconds are of wall-clock time, above 0; infinity waits for ever, as for a debugger.
struct Isolation {
  /// The program that runs a brush, burin-brush-process. Empty: the one beside the file that Burin's code is
  /// in, be it a program or a shared library, else in lib/burin beside its folder, where it is installed.
  std::filesystem::path program = {};

  /// What starting the program, loading a module and creating a brush may take.
  double load_seconds = 20;

  /// What any other call may take that is not made for a batch: begin and end of a stroke, state, curves.
  double call_seconds = 20;

  /// What the evaluation of one batch of at most 1024 nodes may take.
  double batch_seconds = 5;

  /// Address space that a brush may take beyond what its process needs without it, bytes; 0: no bound.
  /// Contents of stamps and fonts count.
  std::uint64_t memory = std::uint64_t{4} << 30;
};

}  // namespace burin
