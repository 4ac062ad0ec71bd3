#pragma once
#include <burin/base/vector.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// A priority queue of nodes by their keys, but for entries whose g differ by less than a 3600th of the
/// longest: they come out as they please. Buckets of equal width, each a linked list [Denardo and Fox 1979].
class BucketQueue {
 public:
  struct Entry {
    std::uint64_t key;  ///< see FrontNode
    Index node;
  };

  /// Empties the queue. Keys whose g is `longest` or more share the last bucket.
  void restart(float longest) {
    buckets_a_unit_ = static_cast<float>(buckets - 1) / longest;
    first_.assign(buckets, no_index);
    links_.clear();
    free_ = no_index;
    lowest_ = buckets;
    size_ = 0;
  }

  bool empty() const { return size_ == 0; }

  void push(std::uint64_t key, Index node) {
    const auto g = std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32));
    const auto bucket = static_cast<Index>(std::min(g * buckets_a_unit_, static_cast<float>(buckets - 1)));
    Index place = free_;
    if (place != no_index) {
      free_ = links_[place].next;
    } else {
      place = static_cast<Index>(links_.size());
      links_.emplace_back();
    }
    links_[place] = {{key, node}, first_[bucket]};
    first_[bucket] = place;
    lowest_ = std::min(lowest_, bucket);
    ++size_;
  }

  /// A lower bound of all g, no lower than a bucket's width. The queue must not be empty.
  float least_g() {
    while (first_[lowest_] == no_index) ++lowest_;
    return static_cast<float>(lowest_) / buckets_a_unit_;
  }

  /// Takes out an entry of the lowest bucket. The queue must not be empty.
  Entry pop() {
    while (first_[lowest_] == no_index) ++lowest_;
    const Index place = first_[lowest_];
    const Entry entry = links_[place].entry;
    first_[lowest_] = links_[place].next;
    links_[place].next = free_;
    free_ = place;
    if (--size_ == 0) lowest_ = buckets;
    return entry;
  }

 private:
  struct Link {
    Entry entry;
    Index next;
  };
  static constexpr Index buckets = 8192;

  float buckets_a_unit_ = 0;  ///< of g
  std::vector<Index> first_;  ///< [bucket] into links_
  std::vector<Link> links_;
  Index free_ = no_index;  ///< into links_
  Index lowest_ = buckets;
  std::size_t size_ = 0;
};

}  // namespace burin
