#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Encodes bytes as base64 with padding [RFC 4648, section 4].
std::string base64(std::string_view bytes);

/// Decodes base64, with padding or without; what follows the padding is passed over. Nothing if the text is
/// none.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace burin
