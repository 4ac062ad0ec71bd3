#pragma once
#include <burin/chart/front/front_node.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin {

/// A priority queue of nodes, ordered by (key, node), for keys that mostly rise. Entries wait in linked
/// lists, one for each of 8192 equal ranges of g; only the entries of the lowest range are sorted [Denardo
/// and Fox 1979].
class BucketQueue {
 public:
  struct Entry {
    FrontKey key;
    Index node;
    float g() const { return g_of(key); }
    bool operator<(const Entry& other) const {
      return key != other.key ? key < other.key : node < other.node;
    }
  };

  /// Empties the queue. Keys whose g is `longest` or more share the last bucket.
  void restart(float longest) {
    buckets_per_unit_ = static_cast<float>(buckets - 1) / longest;
    first_.assign(buckets, no_index);
    links_.clear();
    free_ = no_index;
    sorted_.clear();
    lowest_ = buckets;
    size_ = 0;
  }

  bool empty() const { return size_ == 0; }

  void push(FrontKey key, Index node) {
    const Entry entry{key, node};
    const auto bucket =
        static_cast<Index>(std::min(entry.g() * buckets_per_unit_, static_cast<float>(buckets - 1)));
    ++size_;
    if (bucket == lowest_) return insert_sorted(entry);
    link(bucket, entry);
    if (bucket < lowest_) open(bucket);
  }

  /// The lowest entry. The queue must not be empty.
  const Entry& top() {
    if (sorted_.empty()) open(next_bucket());
    return sorted_.back();
  }

  /// Removes the entry that top() returned; top() must have been called since the last push().
  void pop() {
    sorted_.pop_back();
    --size_;
  }

 private:
  struct Link {
    Entry entry;
    Index next;
  };
  /// Many, so that a bucket has few nodes to sort.
  static constexpr Index buckets = 8192;

  void link(Index bucket, const Entry& entry) {
    Index added = free_;
    if (added != no_index) {
      free_ = links_[added].next;
    } else {
      added = static_cast<Index>(links_.size());
      links_.emplace_back();
    }
    links_[added] = {entry, first_[bucket]};
    first_[bucket] = added;
  }

  void insert_sorted(const Entry& entry) {
    auto before = sorted_.end();
    while (before != sorted_.begin() && *(before - 1) < entry) --before;
    sorted_.insert(before, entry);
  }

  Index next_bucket() const {
    Index bucket = lowest_;
    while (first_[bucket] == no_index) ++bucket;
    return bucket;
  }

  /// Sorts a bucket's entries. Entries left of the bucket that was sorted before return to its list.
  void open(Index bucket) {
    for (const Entry& entry : sorted_) link(lowest_, entry);
    sorted_.clear();
    lowest_ = bucket;
    for (Index moved = first_[bucket]; moved != no_index;) {
      sorted_.push_back(links_[moved].entry);
      const Index next = links_[moved].next;
      links_[moved].next = free_;
      free_ = moved;
      moved = next;
    }
    first_[bucket] = no_index;
    std::ranges::sort(sorted_, [](const Entry& a, const Entry& b) { return b < a; });
  }

  float buckets_per_unit_ = 0;  ///< buckets per unit of g
  std::vector<Index> first_;    ///< [bucket] into links_
  std::vector<Link> links_;
  Index free_ = no_index;      ///< head of the list of unused links
  std::vector<Entry> sorted_;  ///< of bucket lowest_, descending
  Index lowest_ = buckets;
  std::size_t size_ = 0;
};

}  // namespace burin
