// Compares what the header of an ELF file names with the size of the file; see elf(5).
#include <burin/host/plugin/module_file.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

namespace burin {
namespace {

/// The header of an ELF file of 64 bits, without padding.
struct ElfHeader {
  std::array<char, 32> before;
  std::uint64_t segments, sections;  ///< where the tables begin, bytes
  std::array<char, 6> between;
  std::uint16_t segment_bytes, segment_count, section_bytes, section_count, names;
};
static_assert(sizeof(ElfHeader) == 64);

/// An entry of the table of segments.
struct ElfSegment {
  std::array<char, 8> before;
  std::uint64_t offset, address, physical_address, file_bytes;
};

constexpr std::string_view elf_of_64_bits("\177ELF\2", 5);

template <class Value>
bool read(std::ifstream& file, std::uint64_t at, Value& value) {
  file.seekg(static_cast<std::streamoff>(at));
  file.read(reinterpret_cast<char*>(&value), sizeof value);
  return static_cast<bool>(file);
}

}  // namespace

bool is_cut_off(const std::filesystem::path& module) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(module, failed);
  std::ifstream file(module, std::ios::binary);
  ElfHeader header{};
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  const auto read_bytes = static_cast<std::size_t>(file.gcount());
  if (failed || read_bytes < elf_of_64_bits.size() ||
      std::memcmp(&header, elf_of_64_bits.data(), elf_of_64_bits.size()) != 0)
    return false;
  if (read_bytes < sizeof header) return true;
  const auto holds = [&](std::uint64_t begin, std::uint64_t bytes) {
    return begin <= size && bytes <= size - begin;
  };
  if (!holds(header.sections, std::uint64_t{header.section_bytes} * header.section_count)) return true;
  for (std::uint64_t i = 0; i < header.segment_count; ++i) {
    ElfSegment segment{};
    if (!read(file, header.segments + i * header.segment_bytes, segment)) return true;
    if (!holds(segment.offset, segment.file_bytes)) return true;
  }
  return false;
}

}  // namespace burin
