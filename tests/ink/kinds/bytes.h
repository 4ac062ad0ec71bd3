#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin::test {

/// Writes the values of binary pen files, little-endian.
class Bytes {
 public:
  template <class Value>
  Bytes& add(Value value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    text_.append(raw, sizeof value);
    return *this;
  }
  Bytes& add_text(std::string_view text) {
    text_ += text;
    return *this;
  }
  Bytes& add_varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) text_ += static_cast<char>(value | 0x80);
    text_ += static_cast<char>(value);
    return *this;
  }
  /// A signed number whose sign is the lowest bit, as Protocol Buffers have it.
  Bytes& add_zigzag(std::int64_t value) {
    return add_varint(static_cast<std::uint64_t>(value << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  /// A field of a message of Protocol Buffers.
  Bytes& add_field(std::uint64_t number, std::string_view content) {
    return add_varint(number << 3 | 2).add_varint(content.size()).add_text(content);
  }
  Bytes& add_field(std::uint64_t number, std::uint64_t value) {
    return add_varint(number << 3).add_varint(value);
  }
  Bytes& add_field(std::uint64_t number, float value) { return add_varint(number << 3 | 5).add(value); }
  Bytes& add_field(std::uint64_t number, double value) { return add_varint(number << 3 | 1).add(value); }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Signed numbers one behind the other.
inline std::string zigzags(std::initializer_list<std::int64_t> values) {
  Bytes bytes;
  for (const std::int64_t value : values) bytes.add_zigzag(value);
  return bytes.text();
}

/// A RIFF with one chunk.
inline std::string riff(std::string_view form, std::string_view chunk, std::string_view content) {
  const auto size = static_cast<std::uint32_t>(content.size());
  Bytes bytes;
  bytes.add_text("RIFF").add(size + 12).add_text(form).add_text(chunk).add(size).add_text(content);
  if (size % 2 != 0) bytes.add_text(std::string(1, '\0'));
  return bytes.text();
}

/// The check sum of the members of a zip.
inline std::uint32_t crc32_of(std::string_view text) {
  std::uint32_t sum = ~0U;
  for (const char letter : text) {
    sum ^= static_cast<unsigned char>(letter);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

/// A zip of members, names and contents, that are not compressed.
inline std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& members) {
  Bytes zip, directory;
  for (const auto& [name, content] : members) {
    const auto at = static_cast<std::uint32_t>(zip.text().size());
    // The version that can read it, flags, how it is compressed and when it was written.
    const auto add_member = [&, &to_name = name, &to_content = content](Bytes& bytes) {
      const auto size = static_cast<std::uint32_t>(to_content.size());
      bytes.add(std::uint16_t{10}).add(0U).add(0U).add(crc32_of(to_content)).add(size).add(size);
      bytes.add(static_cast<std::uint16_t>(to_name.size())).add(std::uint16_t{0});
    };
    add_member(zip.add_text("PK\3\4"));
    zip.add_text(name).add_text(content);
    add_member(directory.add_text("PK\1\2").add(std::uint16_t{10}));
    directory.add(std::uint16_t{0})
        .add(std::uint16_t{0})
        .add(std::uint16_t{0})
        .add(0U)
        .add(at)
        .add_text(name);
  }
  const auto count = static_cast<std::uint16_t>(members.size());
  const auto at = static_cast<std::uint32_t>(zip.text().size());
  zip.add_text(directory.text()).add_text("PK\5\6").add(0U).add(count).add(count);
  return zip.add(static_cast<std::uint32_t>(directory.text().size())).add(at).add(std::uint16_t{0}).text();
}

}  // namespace burin::test
