#pragma once
#include <burin/surface/csr.h>
#include <burin/surface/triangle_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace burin {

/// The frames of a mesh with texture coordinates in which displacement maps are measured. A point is given by
/// its triangle and its barycentric coordinates. Const functions may be called from several threads at once.
class BaseFrames {
 public:
  /// `base` must outlive the object; no triangle may have a vertex twice. frame() may be called only if
  /// `tangents` is true. Costs O(n), on all threads.
  BaseFrames(const TriangleMesh& base, bool tangents);

  /// The unit normal, interpolated from the vertex normals.
  Vec3d normal(Index triangle, const Vec3d& weights) const;

  /// The frame with rows t, n x t and n. t is dP/du, averaged at each corner over the triangles around it in
  /// the same island, weighted by their areas in texture space, then interpolated and made orthonormal to n.
  /// An island ends where texture coordinates jump or are mirrored. Without an area in texture space t is an
  /// arbitrary tangent.
  Eigen::Matrix3d frame(Index triangle, const Vec3d& weights) const;

 private:
  Vec3f tangent(Index triangle, std::size_t corner) const;

  const TriangleMesh& base_;
  Csr incident_;
  std::vector<Vec3f> normals_;                  ///< [vertex]
  std::vector<std::array<Vec3f, 3>> tangents_;  ///< [triangle][corner] unit or zero; empty without `tangents`
};

}  // namespace burin
