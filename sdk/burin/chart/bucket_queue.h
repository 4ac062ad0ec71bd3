#pragma once
#include <burin/base/vector.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// A priority queue of nodes by (g, vertex, node) for keys that mostly rise: entries wait unsorted in buckets
/// of equal width, and only those of the lowest bucket are sorted [Denardo and Fox 1979].
class BucketQueue {
 public:
  struct Entry {
    std::uint64_t key;  ///< g's bits, which are in order for floats >= 0, above the vertex
    Index node;
    float g() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32)); }
    bool operator<(const Entry& other) const {
      return key != other.key ? key < other.key : node < other.node;
    }
  };

  /// Empties the queue. Keys from `longest` on share the last bucket.
  void restart(float longest) {
    width_inverse_ = static_cast<float>(buckets - 1) / longest;
    first_.assign(buckets, no_index);
    links_.clear();
    free_ = no_index;
    sorted_.clear();
    lowest_ = buckets;
    size_ = 0;
  }

  bool empty() const { return size_ == 0; }

  /// `g` >= 0.
  void push(float g, Index vertex, Index node) {
    const Entry entry{std::uint64_t{std::bit_cast<std::uint32_t>(g)} << 32 | vertex, node};
    const auto bucket = static_cast<Index>(std::min(g * width_inverse_, static_cast<float>(buckets - 1)));
    ++size_;
    if (bucket == lowest_)
      sorted_.insert(std::ranges::upper_bound(sorted_, entry, descending), entry);
    else
      link(bucket, entry);
    if (bucket < lowest_) open(bucket);
  }

  /// The lowest key's g; a lower bound of it where that is cheaper. The queue must not be empty.
  float least_g() {
    while (sorted_.empty()) open(next_bucket());
    return sorted_.back().g();
  }

  /// Takes out the lowest entry. The queue must not be empty.
  Entry pop() {
    while (sorted_.empty()) open(next_bucket());
    const Entry entry = sorted_.back();
    sorted_.pop_back();
    --size_;
    return entry;
  }

 private:
  struct Link {
    Entry entry;
    Index next;
  };
  static constexpr Index buckets = 4096;

  static bool descending(const Entry& a, const Entry& b) { return b < a; }

  void link(Index bucket, const Entry& entry) {
    Index place = free_;
    if (place != no_index) {
      free_ = links_[place].next;
      links_[place] = {entry, first_[bucket]};
    } else {
      place = static_cast<Index>(links_.size());
      links_.push_back({entry, first_[bucket]});
    }
    first_[bucket] = place;
  }

  Index next_bucket() const {
    Index bucket = lowest_ == buckets ? 0 : lowest_;
    while (first_[bucket] == no_index) ++bucket;
    return bucket;
  }

  /// Makes a bucket the sorted one; what is left of the one that was goes back.
  void open(Index bucket) {
    for (const Entry& entry : sorted_) link(lowest_, entry);
    sorted_.clear();
    lowest_ = bucket;
    for (Index place = first_[bucket]; place != no_index;) {
      sorted_.push_back(links_[place].entry);
      const Index next = links_[place].next;
      links_[place].next = free_;
      free_ = place;
      place = next;
    }
    first_[bucket] = no_index;
    std::ranges::sort(sorted_, descending);
  }

  float width_inverse_ = 0;
  std::vector<Index> first_;  ///< [bucket] into links_
  std::vector<Link> links_;
  Index free_ = no_index;      ///< into links_
  std::vector<Entry> sorted_;  ///< of bucket lowest_, descending
  Index lowest_ = buckets;
  std::size_t size_ = 0;
};

}  // namespace burin
