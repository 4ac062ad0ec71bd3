#pragma once
#include <string>

namespace burin {

/// The bytes as base64 with padding, to put files into pages [RFC 4648, section 4].
std::string base64(const std::string& bytes);

}  // namespace burin
