#pragma once
#include <burin/base/vector.h>

#include <algorithm>
#include <vector>

namespace burin {

/// Puts indices in ascending order, each once.
inline void sort_unique(std::vector<Index>& indices) {
  std::ranges::sort(indices);
  const auto [first, last] = std::ranges::unique(indices);
  indices.erase(first, last);
}

}  // namespace burin
