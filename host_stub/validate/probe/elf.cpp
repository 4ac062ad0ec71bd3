// Reads the dynamic section of an ELF file [System V ABI, chapter 5]: needed libraries, imported symbols
// and their versions.
#include "validate/probe/elf.h"

#include <burin/base/file.h>
#include <elf.h>

#include <cstring>
#include <string_view>

#include "validate/probe/check.h"

namespace burin::validate {
namespace {

/// The bytes of a file, with bounds.
class Bytes {
 public:
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}

  template <class Struct>
  Struct at(std::size_t offset) const {
    require(offset <= bytes_.size() && sizeof(Struct) <= bytes_.size() - offset, "the file is cut off");
    Struct read;
    std::memcpy(&read, bytes_.data() + offset, sizeof read);
    return read;
  }

  std::string text(std::size_t offset) const {
    const std::size_t end = bytes_.find('\0', offset);
    require(offset < bytes_.size() && end != bytes_.npos, "the file is cut off");
    return bytes_.substr(offset, end - offset);
  }

 private:
  std::string bytes_;
};

/// The file and its table of sections.
struct Sections {
  const Bytes& file;
  std::vector<Elf64_Shdr> headers;

  /// The headers of this type.
  std::vector<Elf64_Shdr> of(Elf64_Word type) const {
    std::vector<Elf64_Shdr> found;
    for (const Elf64_Shdr& header : headers)
      if (header.sh_type == type) found.push_back(header);
    return found;
  }

  std::string text(const Elf64_Shdr& section, std::size_t offset) const {
    require(section.sh_link < headers.size(), "a section without texts");
    return file.text(headers[section.sh_link].sh_offset + offset);
  }
};

void read_exports(const Sections& sections, ElfFile& elf) {
  for (const Elf64_Shdr& table : sections.of(SHT_DYNSYM))
    for (std::size_t at = 0; at < table.sh_size; at += sizeof(Elf64_Sym)) {
      const auto symbol = sections.file.at<Elf64_Sym>(table.sh_offset + at);
      const bool own = symbol.st_shndx != SHN_UNDEF && ELF64_ST_VISIBILITY(symbol.st_other) == STV_DEFAULT;
      if (own && ELF64_ST_BIND(symbol.st_info) == STB_GLOBAL)
        elf.exports.push_back(sections.text(table, symbol.st_name));
    }
}

void read_needed(const Sections& sections, ElfFile& elf) {
  for (const Elf64_Shdr& table : sections.of(SHT_DYNAMIC))
    for (std::size_t at = 0; at < table.sh_size; at += sizeof(Elf64_Dyn)) {
      const auto entry = sections.file.at<Elf64_Dyn>(table.sh_offset + at);
      if (entry.d_tag == DT_NEEDED) elf.needed.push_back(sections.text(table, entry.d_un.d_val));
    }
}

void read_versions(const Sections& sections, ElfFile& elf) {
  for (const Elf64_Shdr& table : sections.of(SHT_GNU_verneed)) {
    std::size_t library = table.sh_offset;
    for (Elf64_Word k = 0; k < table.sh_info; ++k) {
      const auto need = sections.file.at<Elf64_Verneed>(library);
      std::size_t version = library + need.vn_aux;
      for (Elf64_Half i = 0; i < need.vn_cnt; ++i) {
        const auto aux = sections.file.at<Elf64_Vernaux>(version);
        elf.versions.push_back(sections.text(table, aux.vna_name));
        version += aux.vna_next;
      }
      library += need.vn_next;
    }
  }
}

}  // namespace

ElfFile read_elf(const std::filesystem::path& path) {
  const Bytes file(read_file(path));
  const auto header = file.at<Elf64_Ehdr>(0);
  require(std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS64,
          "is no 64-bit ELF file");
  Sections sections{file, {}};
  for (std::size_t i = 0; i < header.e_shnum; ++i)
    sections.headers.push_back(file.at<Elf64_Shdr>(header.e_shoff + i * sizeof(Elf64_Shdr)));
  ElfFile elf;
  read_exports(sections, elf);
  read_needed(sections, elf);
  read_versions(sections, elf);
  return elf;
}

}  // namespace burin::validate
