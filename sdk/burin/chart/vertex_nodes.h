#pragma once
#include <burin/base/vector.h>

#include <vector>

namespace burin {

/// Maps a few of many vertices to nodes 0, 1, 2, ...: a sparse set [Briggs and Torczon 1993]. Four bytes per
/// vertex; every operation, clear() included, takes constant time, since an entry counts only when its node
/// refers back to the vertex.
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

  /// Assigns the next node to a vertex that has none.
  Index insert(Index vertex) {
    node_of_[vertex] = size();
    vertices_.push_back(vertex);
    return size() - 1;
  }

 private:
  std::vector<Index> node_of_;   ///< [vertex] its node, or a value from before clear()
  std::vector<Index> vertices_;  ///< [node]
};

}  // namespace burin
