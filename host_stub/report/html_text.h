#pragma once
#include <string>
#include <string_view>

namespace burin {

/// The text as content or as a quoted attribute of HTML.
std::string escaped(std::string_view text);

}  // namespace burin
