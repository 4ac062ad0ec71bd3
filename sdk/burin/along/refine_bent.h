#pragma once
#include <burin/along/laid_mesh.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace burin {

/// The position in space of a point of LaidMesh. Any thread, concurrently.
using BendPoint = std::function<Vec3d(const Vec3d& laid)>;

/// How far a bent mesh is refined.
struct BendTolerance {
  double chord = 0;     ///< object units: how far an edge may be from where the bend has it
  double shortest = 0;  ///< object units, before the bend: shorter edges stay whole
  std::size_t most_triangles = 0;
};

/// Bends a mesh: returns the positions of its vertices, and splits edges at their middles until the bend has
/// their quarter points within the tolerance. Triangles on both sides of an edge agree on whether it is
/// split, and so do copies that meet, since the edges of one t are split by where their ends are alone: no
/// T-junction appears. A triangle with two or three split edges is cut into three or four; texture
/// coordinates are halved with their edges. Throws Error where there would be more triangles than allowed. On
/// all threads; the bits do not depend on their number.
std::vector<Vec3d> refine_bent(LaidMesh& mesh, const BendPoint& bend, const BendTolerance& tolerance);

}  // namespace burin
