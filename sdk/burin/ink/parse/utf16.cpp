// Converts UTF-16 to UTF-8 [Unicode Standard, section 3.9].
#include <burin/ink/parse/utf16.h>

#include <cstddef>
#include <cstdint>

namespace burin {
namespace {

constexpr std::string_view little_mark = "\xff\xfe", big_mark = "\xfe\xff";

constexpr std::uint32_t first_high = 0xD800, first_low = 0xDC00, after_low = 0xE000, replacement = 0xFFFD;

bool is_low(std::uint32_t unit) { return unit >= first_low && unit < after_low; }

/// Appends a character as UTF-8.
void append(std::string& text, std::uint32_t character) {
  constexpr std::uint32_t one_byte = 0x80, two_bytes = 0x800, three_bytes = 0x10000, six_bits = 0x3F;
  const auto byte = [&](std::uint32_t mark, unsigned shift, std::uint32_t mask) {
    text += static_cast<char>(mark | (character >> shift & mask));
  };
  if (character < one_byte) return byte(0, 0, one_byte - 1);
  if (character < two_bytes) {
    byte(0xC0, 6, 0x1F);
  } else if (character < three_bytes) {
    byte(0xE0, 12, 0xF);
    byte(0x80, 6, six_bits);
  } else {
    byte(0xF0, 18, 0x7);
    byte(0x80, 12, six_bits);
    byte(0x80, 6, six_bits);
  }
  byte(0x80, 0, six_bits);
}

}  // namespace

bool is_utf16(std::string_view bytes) {
  return bytes.starts_with(little_mark) || bytes.starts_with(big_mark);
}

std::optional<std::string> from_utf16(std::string_view bytes) {
  if (!is_utf16(bytes)) return std::nullopt;
  const bool little = bytes.starts_with(little_mark);
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]),
               second = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<std::uint32_t>(little ? second << 8 | first : first << 8 | second);
  };
  std::string text;
  for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
    const std::uint32_t here = unit(at);
    const bool pair = here >= first_high && here < first_low && at + 3 < bytes.size() && is_low(unit(at + 2));
    if (pair) {
      append(text, 0x10000 + ((here - first_high) << 10) + (unit(at + 2) - first_low));
      at += 2;
    } else {
      append(text, here >= first_high && here < after_low ? replacement : here);
    }
  }
  return text;
}

}  // namespace burin
