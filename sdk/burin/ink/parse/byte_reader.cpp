// Reads the values of binary pen files.
#include <burin/base/error.h>
#include <burin/ink/parse/byte_reader.h>
#include <fmt/format.h>

namespace burin {

std::string_view ByteReader::take_bytes(std::uint64_t count) {
  if (count > left()) reject(fmt::format("{} bytes are told, {} follow", count, left()));
  const std::string_view taken = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  place_ += count;
  return taken;
}

ByteReader ByteReader::part(std::uint64_t count) {
  const std::size_t first = place_;
  return {take_bytes(count), *path_, first};
}

std::uint64_t ByteReader::varint() {
  constexpr int bits = 64;
  std::uint64_t value = 0;
  for (int shift = 0; shift < bits; shift += 7) {
    const auto group = take<std::uint8_t>();
    value |= std::uint64_t{group & 0x7FU} << shift;
    if (group < 0x80) return value;
  }
  reject("an integer of more than 64 bits");
}

std::size_t ByteReader::count(std::uint64_t told, std::size_t least_bytes) const {
  if (told > left() / least_bytes) reject(fmt::format("{} items are told, {} bytes follow", told, left()));
  return told;
}

void ByteReader::reject(std::string_view what) const {
  throw FileError(path_->string(), fmt::format("byte {}", place_), what);
}

}  // namespace burin
