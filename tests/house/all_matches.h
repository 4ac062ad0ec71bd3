#pragma once
#include <regex>
#include <string>

namespace burin::test {

/// The first groups of all matches of the pattern.
template <class Names>
Names all_matches(const std::string& text, const std::regex& pattern) {
  Names names;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    names.insert(names.end(), (*match)[1].str());
  return names;
}

}  // namespace burin::test
