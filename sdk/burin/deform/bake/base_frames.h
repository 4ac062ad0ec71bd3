#pragma once
#include <burin/surface/csr.h>
#include <burin/surface/triangle_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace burin {

/// Frames over a mesh with texture coordinates, which displacement maps are measured in. Points lie in
/// triangles, by their barycentric coordinates there. Any thread.
class BaseFrames {
 public:
  /// `base` must outlive this; no triangle may name a vertex twice. `tangents`: frame() is to be asked.
  BaseFrames(const TriangleMesh& base, bool tangents);

  /// The vertex normals interpolated, unit.
  Vec3d normal(Index triangle, const Vec3d& weights) const;

  /// Rows t, n x t, n. t is dP/du: the mean, weighted by their areas in the texture, over the triangles
  /// around each corner that lie in the same island, interpolated and made orthonormal to n. An island ends
  /// where texture coordinates jump or are mirrored. Where they have no area, any t will do.
  Eigen::Matrix3d frame(Index triangle, const Vec3d& weights) const;

 private:
  Vec3f tangent(Index triangle, std::size_t corner) const;

  const TriangleMesh& base_;
  Csr incident_;
  std::vector<Vec3f> normals_;                  ///< [vertex]
  std::vector<std::array<Vec3f, 3>> tangents_;  ///< [triangle][corner], unit or 0; where asked for
};

}  // namespace burin
