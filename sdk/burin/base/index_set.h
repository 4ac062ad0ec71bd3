#pragma once
#include <burin/base/vector.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// A set of indices that is filled in any order and drained in ascending order without sorting: a bitmap with
/// a second bitmap of its words that are not zero. insert() is O(1). drain() is O(n + r / 4096) for n indices
/// and a range r between the lowest and the highest. One thread.
class IndexSet {
 public:
  explicit IndexSet(Index count);

  void insert(Index index) {
    const std::size_t word = index / 64, group = index / 4096;
    bits_[word] |= std::uint64_t{1} << index % 64;
    summary_[group] |= std::uint64_t{1} << word % 64;
    if (group < lowest_) lowest_ = group;
    if (group > highest_) highest_ = group;
  }

  /// Moves the set's indices to `indices`, ascending, and leaves the set empty.
  void drain(std::vector<Index>& indices);

 private:
  void drain_word(std::size_t word, std::vector<Index>& indices);

  std::vector<std::uint64_t> bits_;     ///< [index / 64]
  std::vector<std::uint64_t> summary_;  ///< [index / 4096]: which words of bits_ are not zero
  std::size_t lowest_, highest_ = 0;    ///< words of summary_ that may be in use
};

}  // namespace burin
