#pragma once
#include <burin/base/vector.h>

#include <functional>
#include <vector>

namespace burin {

/// A piece of a triangle mesh that is being rebuilt. Its border is where the rest of the mesh goes on.
struct PatchMesh {
  std::vector<Vec3d> positions;  ///< object units
  std::vector<Triangle> triangles;
  std::vector<Index> kept;  ///< [vertex] the number elsewhere of one that is neither moved nor removed; of
                            ///< others no_index

  bool is_fixed(Index vertex) const { return kept[vertex] != no_index; }
  Index vertex_count() const { return static_cast<Index>(positions.size()); }
};

/// The same without the vertices that no triangle has, the others in the same order.
PatchMesh without_unused_vertices(const PatchMesh& patch);

/// The cosine of 5 degrees, the angle below which a triangle counts as a sliver.
inline constexpr double sliver_cosine = 0.9962;

/// The cosine of the least angle of a triangle, the greater the worse; 1 for one without area.
double worst_cosine(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// A value at a point, such as a distance, object units.
using PointField = std::function<double(const Vec3d& point)>;

/// The point of the surface that stands for one near it.
using BringPoint = std::function<Vec3d(const Vec3d& point)>;

}  // namespace burin
