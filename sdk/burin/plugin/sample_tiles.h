#pragma once
#include <burin/plugin/tiling.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace burin::plugin {

/// Samples a channel of the stamp of each element's tile: tile(i) returns the Tile of element i, stamp(tile)
/// a reference to its Stamp. Writes values 0 .. count - 1. Calls the host once per stamp and block of 256
/// elements. Throws Error if the host cannot sample.
template <class TileOf, class StampOf>
void sample_tiles(std::size_t count, const TileOf& tile, const StampOf& stamp, const FloatsOut& values,
                  std::uint32_t channel = 0) {
  constexpr std::size_t capacity = 256;
  std::array<Tile, capacity> tiles;
  std::array<const Stamp*, capacity> shown;
  std::array<std::size_t, capacity> members;
  std::array<float, capacity> sampled;
  for (std::size_t first = 0; first < count; first += capacity) {
    const std::size_t size = std::min(capacity, count - first);
    for (std::size_t i = 0; i < size; ++i) {
      tiles[i] = tile(first + i);
      shown[i] = &stamp(tiles[i]);
    }
    for (std::size_t i = 0; i < size; ++i) {
      const Stamp* const one = shown[i];
      if (!one) continue;  // sampled together with an earlier element
      std::size_t found = 0;
      for (std::size_t k = i; k < size; ++k) {
        if (shown[k] != one) continue;
        members[found++] = k;
        shown[k] = nullptr;
      }
      one->sample(
          found, [&](std::size_t k) { return tiles[members[k]].area; }, FloatsOut(sampled.data(), 1),
          channel);
      for (std::size_t k = 0; k < found; ++k) values[first + members[k]] = sampled[k];
    }
  }
}

}  // namespace burin::plugin
