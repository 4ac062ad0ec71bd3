#pragma once
#include <burin/base/vector.h>

#include <vector>

namespace burin {

/// Which node a vertex has, for a few nodes among many vertices: a sparse set [Briggs and Torczon 1993].
/// An entry counts only when its node names the vertex back, so that forgetting all nodes is free.
class VertexNodes {
 public:
  explicit VertexNodes(Index vertex_count) : node_of_(vertex_count, 0) {}

  void clear() { vertices_.clear(); }
  Index size() const { return static_cast<Index>(vertices_.size()); }
  Index vertex(Index node) const { return vertices_[node]; }

  /// The vertex's node, or no_index.
  Index find(Index vertex) const {
    const Index node = node_of_[vertex];
    return node < size() && vertices_[node] == vertex ? node : no_index;
  }

  /// Gives the vertex, which must have no node, the next one.
  Index insert(Index vertex) {
    node_of_[vertex] = size();
    vertices_.push_back(vertex);
    return size() - 1;
  }

 private:
  std::vector<Index> node_of_;   ///< [vertex] a node, possibly of an earlier use
  std::vector<Index> vertices_;  ///< [node]
};

}  // namespace burin
