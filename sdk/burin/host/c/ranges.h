#pragma once
#include <burin/host/c/burin.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin::c {

/// Collects ascending vertices as ranges that are more than `gap` vertices apart.
class Ranges {
 public:
  explicit Ranges(std::uint64_t gap) : gap_(gap) {}

  /// Adds a vertex greater than all before.
  void add(std::uint64_t vertex) {
    if (!ranges_.empty() && vertex - ranges_.back().end <= gap_)
      ranges_.back().end = vertex + 1;
    else
      ranges_.push_back({vertex, vertex + 1});
  }

  /// The ranges, at most `most` of them: where there are more, the smallest gaps are closed, of equal ones
  /// the first. O(n log n) for n ranges.
  std::vector<burin_range> at_most(std::size_t most) const;

 private:
  std::uint64_t gap_;
  std::vector<burin_range> ranges_;
};

}  // namespace burin::c
