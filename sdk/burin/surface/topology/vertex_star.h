#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// An edge from a vertex to `other`, with the numbers of faces that traverse it in either direction.
struct StarEdge {
  Index other = no_index;
  int outward = 0,
      inward = 0;         ///< faces in which `other` follows the vertex, and those in which it precedes it
  Index face = no_index;  ///< one of the faces
  Index other_face = no_index;  ///< the last of the other faces, if any

  int faces() const { return outward + inward; }
  bool flipped() const { return faces() == 2 && outward != inward; }
};

/// The faces around one vertex: the edges at the vertex, and the fans that the faces form across these edges.
/// Any number of polygons may meet at an edge. n faces cost O(n log n). The object is reused from vertex to
/// vertex to keep its memory.
class VertexStar {
 public:
  void clear() { corners_.clear(); }

  /// Adds a face in which the vertex lies between `previous` and `next`.
  void add(Index face, Index previous, Index next) { corners_.push_back({face, previous, next}); }

  /// Computes edges and fans. To be called after all faces were added.
  void connect();

  /// The edges by ascending `other`. Valid until the next connect().
  std::span<const StarEdge> edges() const { return edges_; }

  /// The number of groups of faces that are connected by edges at the vertex; 1 at a vertex of a manifold.
  int fans() const { return fans_; }

 private:
  struct Corner {
    Index face, previous, next;
  };
  struct Side {
    Index other, corner;
    bool outward;
    auto operator<=>(const Side&) const = default;
  };
  Index fan_of(Index corner);
  void join(Index a, Index b);

  std::vector<Corner> corners_;
  std::vector<Side> sides_;
  std::vector<StarEdge> edges_;
  std::vector<Index> parents_;  ///< [corner] union-find of the fans
  int fans_ = 0;
};

}  // namespace burin
