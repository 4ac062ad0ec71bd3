// Hashes bytes with XXH3 of the xxHash library.
#include <burin/base/hash.h>
#include <fmt/format.h>
#include <xxhash.h>

namespace burin {

std::uint64_t hash_bytes(const void* bytes, std::size_t size) { return XXH3_64bits(bytes, size); }

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace burin
