#pragma once
#include <optional>
#include <string_view>

namespace burin {

/// Removes one code point from the front of a text, which must not be empty, and returns it. Returns nothing
/// and leaves the text unchanged if its first bytes are not valid UTF-8 [RFC 3629].
std::optional<char32_t> pop_code_point(std::string_view& text);

/// Whether all of a text is valid UTF-8.
bool is_utf8(std::string_view text);

/// Whether a code point is a C0 or C1 control (line breaks included), or Unicode's line or paragraph
/// separator.
constexpr bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

}  // namespace burin
