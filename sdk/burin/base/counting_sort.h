#pragma once
#include <burin/base/parallel.h>
#include <burin/base/unset_vector.h>
#include <burin/base/vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Stable counting sort of `count` items by integer keys, on up to 4 threads. The result does not depend on
/// the number of threads. keys(i, emit) must call emit(key) for every key of item i, each below `buckets`; an
/// item may have none or several. place(i, position) is then called once per emitted key, concurrently, with
/// the position of the item in the order of keys, and of i among equal keys. Returns the first position of
/// each bucket, followed by the total. Runs in O(keys + buckets); needs 4 bytes per bucket and thread.
template <class Keys, class Place>
std::vector<Index> counting_sort(std::size_t count, std::size_t buckets, const Keys& keys,
                                 const Place& place) {
  const std::size_t most_parts = std::min<std::size_t>(thread_count(), 4);
  const std::size_t items_per_part = std::max<std::size_t>((count + most_parts - 1) / most_parts, 1);
  std::vector<std::vector<Index>> next((count + items_per_part - 1) / items_per_part);
  parallel_blocks(count, items_per_part, [&](std::size_t begin, std::size_t end) {
    std::vector<Index>& counts = next[begin / items_per_part];
    counts.resize(buckets);
    for (std::size_t i = begin; i < end; ++i) keys(i, [&](std::size_t key) { ++counts[key]; });
  });

  std::vector<Index> offsets(buckets + 1);
  Index position = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    offsets[bucket] = position;
    for (std::vector<Index>& counts : next) {
      const Index size = counts[bucket];
      counts[bucket] = position;
      position += size;
    }
  }
  offsets[buckets] = position;

  parallel_blocks(count, items_per_part, [&](std::size_t begin, std::size_t end) {
    std::vector<Index>& positions = next[begin / items_per_part];
    for (std::size_t i = begin; i < end; ++i) keys(i, [&](std::size_t key) { place(i, positions[key]++); });
  });
  return offsets;
}

/// Stable least-significant-digit radix sort by the bits [first_bit, end_bit) of the keys, 11 bits per pass.
inline void radix_sort(UnsetVector<std::uint64_t>& keys, int first_bit, int end_bit) {
  constexpr int digit_bits = 11;
  UnsetVector<std::uint64_t> sorted(keys.size());
  for (int shift = first_bit; shift < end_bit; shift += digit_bits) {
    const std::size_t buckets = std::size_t{1} << std::min(digit_bits, end_bit - shift);
    counting_sort(
        keys.size(), buckets,
        [&](std::size_t i, const auto& emit) { emit(keys[i] >> shift & (buckets - 1)); },
        [&](std::size_t i, std::size_t position) { sorted[position] = keys[i]; });
    keys.swap(sorted);
  }
}

}  // namespace burin
