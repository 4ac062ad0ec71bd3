#pragma once
#include <burin/surface/csr.h>
#include <opensubdiv/far/topologyLevel.h>

#include <span>

namespace burin {

/// Frames that move with the surface at the vertices of one refined level, for details to be stored in. They
/// depend on nothing but the positions around a vertex and the level's faces.
class DetailFrames {
 public:
  /// `level` >= 1 of a refinement, which must outlive this.
  explicit DetailFrames(const OpenSubdiv::Far::TopologyLevel& level);

  /// Orthonormal and right-handed; columns: the direction to the next vertex of the first face around,
  /// across, and the normal (NormalSum of the faces). Where degenerate faces leave one of these without a
  /// direction, another edge or an axis stands in. `positions`: finite, [vertex of the level]. Any thread.
  Eigen::Matrix3d at(std::span<const Vec3f> positions, Index vertex) const;

 private:
  /// The vertex so many steps round its face from a corner.
  Index vertex_of(Index corner, Index steps) const;

  const OpenSubdiv::Far::TopologyLevel& level_;
  Index face_size_;
  Csr corners_;  ///< around each vertex; corner i is the one numbered i % face_size_ of face i / face_size_
};

}  // namespace burin
