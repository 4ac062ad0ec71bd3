#pragma once
#include <optional>
#include <string_view>

namespace burin {

/// Takes one code point from the front of a text that is not empty; nothing where its bytes are no UTF-8
/// [RFC 3629].
std::optional<char32_t> take_code_point(std::string_view& text);

/// C0 and C1 controls, line breaks among them, and Unicode's line and paragraph separators.
constexpr bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

}  // namespace burin
