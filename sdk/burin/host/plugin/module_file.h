#pragma once
#include <filesystem>

namespace burin {

/// Whether a file begins as an ELF library of 64 bits and ends before what its header names, its segments or
/// its table of sections. False for files that cannot be read, for those that are no such library, and on
/// other systems than Linux.
bool is_cut_off(const std::filesystem::path& module);

}  // namespace burin
