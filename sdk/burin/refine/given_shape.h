#pragma once
#include <burin/surface/surface.h>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace burin {

/// The vertices that a refinement added; empty for other patches.
struct AddedVertices {
  std::span<const Vec3f> given;  ///< [new vertex] where it would be on the surface as it was given
  std::span<const float> edges;  ///< [new vertex] the length of edges for which it was added, object units
};

/// For which lengths of edges refinements keep vertices that they added.
struct KeptEdges {
  std::vector<Index> vertices;
  std::vector<float> edges;  ///< [i] of vertices[i], object units
};

/// The shape that a surface had before anything was drawn on it, by which automatic refinements go: what
/// strokes stretch is not coarse, since coordinates of a stroke are those of the surface beneath.
///
/// The gap at an edge is twice the distance from its middle to the nearest corner of its triangles: the
/// length of the edge, or less where a corner lies near the middle of the long side of a sliver. So single
/// slivers in a fine mesh leave no gap, and rows of them, as CAD makes, do.
class GivenShape {
 public:
  /// That of a surface as it is. Costs O(edges), on all threads.
  explicit GivenShape(const Surface& surface);

  /// The greatest gap at the edges of a vertex, object units.
  float gap(Index vertex) const { return gaps_[vertex]; }
  float greatest_gap() const { return greatest_; }  ///< of all

  /// Whether a vertex was added by a refinement.
  bool is_refined(Index vertex) const { return !edges_.empty() && edges_[vertex] > 0; }

  /// Whether a vertex was added by a refinement for edges of at most this length, object units, and was not
  /// kept for longer ones since.
  bool is_finer(Index vertex, double edge) const {
    return is_refined(vertex) && static_cast<double>(edges_[vertex]) <= edge;
  }
  float least_edge() const { return least_edge_; }  ///< for which a vertex was added; infinite if none was

  /// Sets for which lengths vertices are kept; `kept` gets those for which they were.
  void exchange(KeptEdges& kept);

  /// Keeps the positions as they are, unless some are kept: to be called before a stroke moves vertices that
  /// others may have to refine. 12 bytes a vertex.
  void keep_positions(const Surface& surface);

  /// [vertex] where it was on this surface, object units; if nothing is kept, where it is.
  std::span<const Vec3f> positions(const Surface& surface) const {
    return positions_.empty() ? surface.positions : positions_;
  }

  /// That of the surface after a patch. `came_from`: see PatchedSurface. The new vertices of patches that are
  /// no refinements are given where they are. Gaps at old vertices may become less.
  GivenShape patched(const Surface& after, std::span<const Index> came_from,
                     const AddedVertices& added) const;

  /// That of the surface after a patch without new vertices. `changed`: old vertices that may have other
  /// edges, ascending.
  GivenShape coarsened(const Surface& after, std::span<const Index> came_from,
                       std::span<const Index> changed) const;

 private:
  GivenShape() = default;
  GivenShape carried(const Surface& after, std::span<const Index> came_from,
                     const AddedVertices& added) const;
  void find_extremes();

  std::vector<float> gaps_;       ///< [vertex]
  std::vector<float> edges_;      ///< [vertex] for which a refinement added it, or else 0; empty: all of them
  std::vector<Vec3f> positions_;  ///< [vertex] or empty
  float greatest_ = 0, least_edge_ = std::numeric_limits<float>::infinity();
};

/// The squared length by which an edge is judged, from its length as it is and as it was given: what is drawn
/// can make edges longer, and solids are joined to what was drawn.
inline double judged_squared(const Vec3d& from, const Vec3d& to, const Vec3d& given_from,
                             const Vec3d& given_to) {
  return std::min((to - from).squaredNorm(), (given_to - given_from).squaredNorm());
}

/// The same of the edge between two vertices; both spans: [vertex] positions.
inline double judged_squared(std::span<const Vec3f> positions, std::span<const Vec3f> given, Index a,
                             Index b) {
  return judged_squared(positions[a].cast<double>(), positions[b].cast<double>(), given[a].cast<double>(),
                        given[b].cast<double>());
}

}  // namespace burin
