// Compares what the header of an ELF file names with the size of the file; see elf(5).
#include <burin/host/plugin/module_file.h>

#if defined(__linux__)
#include <elf.h>

#include <cstdint>
#include <cstring>
#include <fstream>

namespace burin {

bool is_cut_off(const std::filesystem::path& module) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(module, failed);
  std::ifstream file(module, std::ios::binary);
  Elf64_Ehdr header{};
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  const std::streamsize had = file.gcount();
  const bool is_elf = had > EI_CLASS && std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
                      header.e_ident[EI_CLASS] == ELFCLASS64;
  if (failed || !is_elf) return false;
  if (!file) return true;
  const auto holds = [&](std::uint64_t begin, std::uint64_t bytes) {
    return begin <= size && bytes <= size - begin;
  };
  if (!holds(header.e_shoff, std::uint64_t{header.e_shentsize} * header.e_shnum)) return true;
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    file.seekg(static_cast<std::streamoff>(header.e_phoff + i * header.e_phentsize));
    file.read(reinterpret_cast<char*>(&segment), sizeof segment);
    if (!file || !holds(segment.p_offset, segment.p_filesz)) return true;
  }
  return false;
}

}  // namespace burin
#else
namespace burin {

bool is_cut_off(const std::filesystem::path&) { return false; }

}  // namespace burin
#endif
