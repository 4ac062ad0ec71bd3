#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace burin {

/// Reads little-endian values from the front of a part of a binary file. Whatever reaches beyond the part is
/// refused with a FileError that names the byte of the file, from 0. The file's bytes and its path must
/// outlive the reader.
class ByteReader {
 public:
  /// `first`: where the bytes begin in the file.
  ByteReader(std::string_view bytes, const std::filesystem::path& path, std::size_t first = 0)
      : bytes_(bytes), path_(&path), place_(first) {}

  bool empty() const { return bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }
  std::string_view bytes() const { return bytes_; }
  std::size_t place() const { return place_; }
  const std::filesystem::path& path() const { return *path_; }

  /// An integer or a floating-point number.
  template <class Value>
  Value take() {
    static_assert(std::endian::native == std::endian::little);
    Value value;
    std::memcpy(&value, take_bytes(sizeof value).data(), sizeof value);
    return value;
  }

  std::string_view take_bytes(std::uint64_t count);

  /// The next `count` bytes, to be read by themselves.
  ByteReader part(std::uint64_t count);

  /// An integer in groups of 7 bits, the low ones first.
  std::uint64_t varint();

  /// The number of items that follow. Refuses one that cannot be true, since each has `least_bytes`.
  std::size_t count(std::uint64_t told, std::size_t least_bytes) const;

  [[noreturn]] void reject(std::string_view what) const;

 private:
  std::string_view bytes_;
  const std::filesystem::path* path_;
  std::size_t place_;
};

}  // namespace burin
