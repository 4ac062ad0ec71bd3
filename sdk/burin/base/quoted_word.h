#pragma once
#include <string>
#include <string_view>

namespace burin {

/// A word of a file as messages show it: between quotes, at most 40 bytes of it, so that a message stays a
/// line of bounded length, and with control characters and what is no UTF-8 as \xHH.
std::string quoted_word(std::string_view word);

/// A text of any length with the same characters as \xHH, so that it can neither steer a terminal nor break a
/// line.
std::string printable(std::string_view text);

}  // namespace burin
