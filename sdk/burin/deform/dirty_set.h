#pragma once
#include <burin/base/vector.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// A set of vertices that is filled in any order and emptied in ascending order without sorting: a bit a
/// vertex, and a bit for each word of those. Emptying costs in proportion to the vertices and to 1/4096 of
/// the range between the lowest and the highest.
class DirtySet {
 public:
  explicit DirtySet(Index vertex_count);

  void insert(Index vertex);

  /// Moves the set's vertices to `vertices`, ascending, and leaves the set empty.
  void drain(std::vector<Index>& vertices);

 private:
  void drain_word(std::size_t word, std::vector<Index>& vertices);

  std::vector<std::uint64_t> bits_;     ///< [vertex / 64]
  std::vector<std::uint64_t> summary_;  ///< [vertex / 4096]: which words of bits_ are not zero
  std::size_t lowest_, highest_ = 0;    ///< words of summary_ that may be in use
};

}  // namespace burin
