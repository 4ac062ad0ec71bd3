#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace burin {

/// The XXH3 64-bit hash of `size` bytes. Equal results of two runs have equal hashes.
std::uint64_t hash_bytes(const void* bytes, std::size_t size);

/// The hash as 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace burin
