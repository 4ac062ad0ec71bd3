#include <burin/host/descriptor_check.h>

#include <bit>
#include <cstdint>

namespace burin {
namespace {

/// Reads one code point and moves on; false where the bytes are no UTF-8 [RFC 3629].
bool read_code_point(const unsigned char*& at, std::uint32_t& code) {
  const int length = std::countl_one(*at);
  if (length == 1 || length > 4) return false;
  code = *at++ & (0x7fu >> length);
  for (int i = 1; i < length; ++i, ++at) {
    if ((*at & 0xc0u) != 0x80u) return false;
    code = code << 6 | (*at & 0x3fu);
  }
  constexpr std::uint32_t lowest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code >= lowest[length] && code <= 0x10ffff && !surrogate;
}

}  // namespace

bool is_text(const char* text) {
  if (!text || *text == '\0') return false;
  const auto* at = reinterpret_cast<const unsigned char*>(text);
  while (*at != 0) {
    std::uint32_t code = 0;
    if (!read_code_point(at, code) || code < 0x20 || code == 0x7f) return false;
  }
  return true;
}

}  // namespace burin
