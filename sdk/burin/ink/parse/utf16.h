#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Whether a text begins with a byte order mark of UTF-16.
bool is_utf16(std::string_view bytes);

/// The text in UTF-8 if it begins with a byte order mark of UTF-16, without the mark; nothing for other
/// texts. Halves of characters without the other half become U+FFFD.
std::optional<std::string> from_utf16(std::string_view bytes);

}  // namespace burin
