#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burin {

/// Reads an unsigned little-endian number of 1 to 4 bytes at offset `at`. The bytes must exist.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t size = 4) {
  std::uint32_t number = 0;
  for (std::size_t i = size; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

}  // namespace burin
