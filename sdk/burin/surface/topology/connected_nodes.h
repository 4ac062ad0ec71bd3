#pragma once
#include <burin/surface/csr.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// Finds the nodes of a graph that are connected with given ones through nodes that satisfy a condition.
/// Memory is constant and reused from call to call.
class ConnectedNodes {
 public:
  /// Returns `starts` and all nodes connected with them through nodes for which within(node) is true, in
  /// breadth-first order. The search stops after `most` nodes have been examined. The span is valid until the
  /// next call.
  template <class Within>
  std::span<const Index> find(const Csr& neighbours, std::span<const Index> starts, const Within& within) {
    table_.fill(no_index);
    found_.clear();
    known_ = 0;
    for (const Index start : starts)
      if (insert(start)) found_.push_back(start);
    for (std::size_t i = 0; i < found_.size(); ++i) {
      for (const Index neighbour : neighbours[found_[i]]) {
        if (known_ == most) return found_;
        if (insert(neighbour) && within(neighbour)) found_.push_back(neighbour);
      }
    }
    return found_;
  }

 private:
  static constexpr std::size_t table_size = 4096, most = table_size / 2;

  /// Returns false if the node was inserted before.
  bool insert(Index node) {
    std::size_t slot = node * std::size_t{2654435761} / 64 % table_size;
    while (table_[slot] != no_index && table_[slot] != node) slot = (slot + 1) % table_size;
    if (table_[slot] == node) return false;
    table_[slot] = node;
    ++known_;
    return true;
  }

  std::array<Index, table_size> table_;
  std::size_t known_ = 0;
  std::vector<Index> found_;
};

}  // namespace burin
