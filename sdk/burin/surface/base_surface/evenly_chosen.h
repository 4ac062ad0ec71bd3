#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// At most `most` of all, evenly chosen.
template <class Value>
std::vector<Value> evenly_chosen(std::span<const Value> all, std::size_t most) {
  const std::size_t count = std::min(all.size(), most);
  std::vector<Value> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(all[i * all.size() / count]);
  return chosen;
}

}  // namespace burin
