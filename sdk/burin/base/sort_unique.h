#pragma once
#include <burin/base/vector.h>

#include <algorithm>
#include <vector>

namespace burin {

/// Sorts indices in ascending order and removes duplicates.
inline void sort_unique(std::vector<Index>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

}  // namespace burin
