#pragma once
#include <burin/surface/surface.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace burin {

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
  float gap(Index vertex) const { return std::abs(gaps_[vertex]); }
  float greatest_gap() const { return greatest_; }  ///< of all

  /// Whether a vertex was added by a refinement.
  bool is_refined(Index vertex) const { return std::signbit(gaps_[vertex]); }

  /// Keeps the positions as they are, unless some are kept: to be called before a stroke moves vertices that
  /// others may have to refine. 12 bytes a vertex.
  void keep_positions(const Surface& surface);

  /// [vertex] where it was on this surface, object units; if nothing is kept, where it is.
  std::span<const Vec3f> positions(const Surface& surface) const {
    return positions_.empty() ? surface.positions : positions_;
  }

  /// That of the surface after a patch. `came_from`: see PatchedSurface; `given`: [new vertex] of a
  /// refinement, where it would be on the surface as it was given; empty for other patches, whose vertices
  /// are given where they are. Gaps at old vertices may become less.
  GivenShape patched(const Surface& after, std::span<const Index> came_from,
                     std::span<const Vec3f> given) const;

 private:
  GivenShape() = default;
  void find_greatest();

  std::vector<float> gaps_;       ///< [vertex] with the sign bit set where it was added by a refinement
  std::vector<Vec3f> positions_;  ///< [vertex] or empty
  float greatest_ = 0;
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
