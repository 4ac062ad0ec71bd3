#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// An edge from a vertex to `other`, and how many faces run along it either way.
struct StarEdge {
  Index other;
  int outward = 0, inward = 0;  ///< faces that go to `other` after the vertex, and that come from it
  Index face = no_index;        ///< one of them, and the last of the rest, if any
  Index other_face = no_index;

  int faces() const { return outward + inward; }
  bool flipped() const { return faces() == 2 && outward != inward; }
};

/// The faces around one vertex: its edges, and the fans that the faces form across them. Works for any
/// polygons, however many meet at an edge. Reused from vertex to vertex to keep its memory.
class VertexStar {
 public:
  void clear() { corners_.clear(); }

  /// A face that comes to the vertex from `previous` and goes on to `next`.
  void add(Index face, Index previous, Index next) { corners_.push_back({face, previous, next}); }

  /// To be called when all faces are added.
  void connect();

  /// Edges by ascending `other`. Valid until the next connect().
  std::span<const StarEdge> edges() const { return edges_; }

  /// Groups of faces connected by edges at the vertex: 1 at a vertex of a manifold.
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
