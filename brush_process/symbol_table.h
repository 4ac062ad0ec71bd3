#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace burin::process {

/// The functions of a shared library by their addresses, from the symbol table of its file, which has those
/// too that are not exported. The file stays mapped into memory, so that find() may run in a signal handler.
class SymbolTable {
 public:
  /// Empty.
  SymbolTable() = default;

  /// Of a file that has no such table, or is no ELF library of 64 bits, an empty one.
  explicit SymbolTable(const std::filesystem::path& library);
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;
  ~SymbolTable();

  /// The name, as linkers see it, of the function at this place of the library; null: not known.
  const char* find(std::uint64_t offset) const;

 private:
  template <class Struct>
  const Struct* at(std::uint64_t offset, std::uint64_t count) const;
  void find_symbols();

  const std::byte* file_ = nullptr;
  std::size_t size_ = 0;
  const void* symbols_ = nullptr;
  std::size_t symbol_count_ = 0;
  const char* names_ = nullptr;
  std::size_t names_size_ = 0;
};

}  // namespace burin::process
