// Reads the section headers of an ELF file; see elf(5). Costs a pass over the table for every look.
#include "symbol_table.h"

#include <elf.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>

namespace burin::process {

SymbolTable::SymbolTable(const std::filesystem::path& library) {
  const int file = open(library.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  struct stat status {};
  if (fstat(file, &status) == 0 && status.st_size > 0) {
    void* memory = mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ, MAP_PRIVATE, file, 0);
    if (memory != MAP_FAILED) {
      file_ = static_cast<const std::byte*>(memory);
      size_ = static_cast<std::size_t>(status.st_size);
      find_symbols();
    }
  }
  close(file);
}

SymbolTable::~SymbolTable() {
  if (file_) munmap(const_cast<std::byte*>(file_), size_);
}

/// An array within the file; null if it is not.
template <class Struct>
const Struct* SymbolTable::at(std::uint64_t offset, std::uint64_t count) const {
  const bool within = offset <= size_ && count <= (size_ - offset) / sizeof(Struct);
  return within && offset % alignof(Struct) == 0 ? reinterpret_cast<const Struct*>(file_ + offset) : nullptr;
}

void SymbolTable::find_symbols() {
  const auto* header = at<Elf64_Ehdr>(0, 1);
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 ||
      header->e_ident[EI_CLASS] != ELFCLASS64)
    return;
  const auto* sections = at<Elf64_Shdr>(header->e_shoff, header->e_shnum);
  for (std::size_t i = 0; sections && i < header->e_shnum; ++i) {
    const Elf64_Shdr& section = sections[i];
    if (section.sh_type != SHT_SYMTAB || section.sh_link >= header->e_shnum) continue;
    const Elf64_Shdr& names = sections[section.sh_link];
    const std::size_t count = section.sh_size / sizeof(Elf64_Sym);
    const auto* symbols = at<Elf64_Sym>(section.sh_offset, count);
    const char* text = at<char>(names.sh_offset, names.sh_size);
    // The table of names ends with a zero, so that every name in it ends.
    if (!symbols || !text || names.sh_size == 0 || text[names.sh_size - 1] != '\0') return;
    symbols_ = symbols;
    symbol_count_ = count;
    names_ = text;
    names_size_ = names.sh_size;
    return;
  }
}

const char* SymbolTable::find(std::uint64_t offset) const {
  const auto* symbols = static_cast<const Elf64_Sym*>(symbols_);
  for (std::size_t i = 0; i < symbol_count_; ++i) {
    const Elf64_Sym& symbol = symbols[i];
    if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_name >= names_size_) continue;
    if (offset >= symbol.st_value && offset - symbol.st_value < symbol.st_size)
      return names_ + symbol.st_name;
  }
  return nullptr;
}

}  // namespace burin::process
