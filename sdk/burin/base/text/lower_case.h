#pragma once
#include <string>

namespace burin {

/// The text with its ASCII letters in lower case, whatever the locale.
inline std::string in_lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace burin
