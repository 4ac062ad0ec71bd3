#pragma once
#include <string>
#include <string_view>

namespace burin {

/// A word of a file for a message: in quotes, truncated to 40 bytes, so that a message is a line of bounded
/// length. Control characters and bytes that are not UTF-8 become \xHH.
std::string quoted_word(std::string_view word);

/// A text of any length in which control characters and bytes that are not UTF-8 become \xHH, so that it can
/// neither control a terminal nor break a line.
std::string printable(std::string_view text);

}  // namespace burin
