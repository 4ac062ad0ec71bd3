#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace burin {

/// XXH3 64-bit of `size` bytes: names a result, so that two runs can be told equal.
std::uint64_t hash_bytes(const void* bytes, std::size_t size);

/// The hash as 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace burin
