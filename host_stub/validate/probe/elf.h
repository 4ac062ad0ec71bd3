#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace burin::validate {

/// What a shared library tells the system's loader.
struct ElfFile {
  std::vector<std::string> exports;   ///< strong global symbols that it defines
  std::vector<std::string> needed;    ///< libraries
  std::vector<std::string> versions;  ///< versions of symbols of others, "GLIBC_2.34"
};

/// Reads a library of this machine's kind. Throws Failed if it is damaged or another's.
ElfFile read_elf(const std::filesystem::path& path);

}  // namespace burin::validate
