#pragma once
#include <burin/base/vector.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// Of the neighbours of a node that has more than this, so many represent all: the hub of a fan would cost in
/// proportion to the square of its spokes.
inline constexpr std::size_t most_neighbours = 64;

/// The neighbours of a node, or those that represent them, evenly chosen.
inline std::vector<Index> representatives(std::span<const Index> neighbours) {
  const std::size_t count = std::min(neighbours.size(), most_neighbours);
  std::vector<Index> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(neighbours[i * neighbours.size() / count]);
  return chosen;
}

}  // namespace burin
