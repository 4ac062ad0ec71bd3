#pragma once
#include <string>

namespace burin {

/// Encodes bytes as base64 with padding [RFC 4648, section 4], to embed files in HTML pages.
std::string base64(const std::string& bytes);

}  // namespace burin
