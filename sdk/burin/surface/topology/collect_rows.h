#pragma once
#include <burin/base/parallel.h>
#include <burin/surface/csr.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace burin {

/// Builds lists whose lengths are not known in advance: append(row, items) appends the items of a row. It is
/// called on all threads, in ascending order within each block of `rows_per_block` rows. The result does not
/// depend on the number of threads.
template <class Append>
Csr collect_rows(Index rows, std::size_t rows_per_block, const Append& append) {
  Csr result;
  result.offsets.resize(rows + std::size_t{1});
  std::vector<UnsetVector<Index>> found(rows / rows_per_block + 1);  // [block]
  parallel_blocks(rows, rows_per_block, [&](std::size_t begin, std::size_t end) {
    UnsetVector<Index>& items = found[begin / rows_per_block];
    for (auto row = static_cast<Index>(begin); row < end; ++row) {
      const std::size_t before = items.size();
      append(row, items);
      result.offsets[row + 1] = static_cast<Index>(items.size() - before);
    }
  });
  std::inclusive_scan(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.items.resize(result.offsets.back());
  parallel_blocks(found.size(), 1, [&](std::size_t block, std::size_t) {
    std::ranges::copy(found[block], result.items.begin() + result.offsets[block * rows_per_block]);
  });
  return result;
}

}  // namespace burin
