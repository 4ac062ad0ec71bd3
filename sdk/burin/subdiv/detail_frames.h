#pragma once
#include <burin/surface/csr.h>
#include <opensubdiv/far/topologyLevel.h>

#include <span>

namespace burin {

/// Frames at the vertices of one refined level, in which details are stored so that they move with the
/// surface. A frame depends only on the positions around its vertex and on the level's faces.
class DetailFrames {
 public:
  /// `level` >= 1 of a refinement, which must outlive this.
  explicit DetailFrames(const OpenSubdiv::Far::TopologyLevel& level);

  /// The orthonormal, right-handed frame of a vertex. Its columns are the direction to the next vertex of the
  /// first incident face, the direction across, and the normal (NormalSum of the faces). If degenerate faces
  /// leave one of these undefined, another edge or a coordinate axis replaces it. `positions`: finite,
  /// [vertex of the level]. Any thread.
  Eigen::Matrix3d at(std::span<const Vec3f> positions, Index vertex) const;

 private:
  /// The vertex that is this number of steps from a corner along its face.
  Index vertex_of(Index corner, Index steps) const;

  const OpenSubdiv::Far::TopologyLevel& level_;
  Index face_size_;
  Csr corners_;  ///< [vertex] its corners; corner i has number i % face_size_ in face i / face_size_
};

}  // namespace burin
