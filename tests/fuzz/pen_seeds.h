#pragma once
#include <span>
#include <string>

namespace burin::fuzz {

/// A small pen file.
struct PenSeed {
  const char* kind;  ///< PenFileKind::name
  std::string bytes;
};

/// At least one file of each kind that the fuzzer tries.
std::span<const PenSeed> pen_seeds();

}  // namespace burin::fuzz
