#pragma once
#include <string>
#include <string_view>

namespace burin {

/// Escapes a text for use as content or as a quoted attribute of HTML or XML.
std::string escaped(std::string_view text);

}  // namespace burin
