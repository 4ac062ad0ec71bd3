// Decodes UTF-8 code point by code point, and rejects overlong forms, surrogates and values above 10FFFF [RFC
// 3629].
#include <burin/base/text/utf8.h>

#include <bit>

namespace burin {

std::optional<char32_t> pop_code_point(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const auto ones = static_cast<std::size_t>(std::countl_one(first));
  if (ones == 1 || ones > 4 || text.size() < ones) return std::nullopt;
  const std::size_t length = ones == 0 ? 1 : ones;
  char32_t code = first & (0x7fu >> ones);
  for (const char c : text.substr(1, length - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0u) != 0x80u) return std::nullopt;
    code = code << 6 | (byte & 0x3fu);
  }
  constexpr char32_t lowest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (code < lowest[ones] || code > 0x10ffff || surrogate) return std::nullopt;
  text.remove_prefix(length);
  return code;
}

bool is_utf8(std::string_view text) {
  while (!text.empty())
    if (!pop_code_point(text)) return false;
  return true;
}

}  // namespace burin
