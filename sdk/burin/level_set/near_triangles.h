#pragma once
#include <burin/base/trees/box_lanes.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin {

/// Triangles of a surface near a place, for many searches around it: each of these looks at all of their
/// boxes in lanes, which takes less time than to descend a tree. Any thread, concurrently. The surface must
/// outlive it.
class NearTriangles {
 public:
  NearTriangles(const Surface& surface, std::span<const Index> triangles);

  /// Those of which a point may be as near to a position as that.
  NearTriangles within(const Vec3f& position, float max_distance) const;

  /// The closest to a position; among equally close ones that with the lowest index. The closer `guess` is,
  /// which is one of them or no_index, the faster.
  Index closest(const Vec3f& position, Index guess) const;

 private:
  explicit NearTriangles(const Surface& surface) : surface_(&surface) {}

  void add(Index triangle, const LanedBoxes::Box& box);

  /// Calls visit(i) for the boxes that are as near as reaches(squared distance) says, in their order.
  template <class Reaches, class Visit>
  void for_near(const Vec3f& position, const Reaches& reaches, const Visit& visit) const;

  const Surface* surface_;
  std::vector<Index> triangles_;
  LanedBoxes boxes_;  ///< [i] of triangle i
};

}  // namespace burin
