#pragma once
#include <burin/remesh/patch_mesh.h>

namespace burin {

/// Where and how a patch is remeshed.
struct Improvement {
  PointField size;   ///< length of edges to aim at, object units
  BringPoint bring;  ///< to the surface, from near it
  /// Whether a vertex is on a crease, along which alone it may change.
  std::function<bool(const Vec3d&)> crease;
  /// Whether edges there shall have the size. Small angles are mended everywhere.
  std::function<bool(const Vec3d&)> smooth;
};

/// Remeshes a patch so that its triangles have edges of about the size and no small angles. Fixed vertices,
/// the border and its edges stay.
void improve(PatchMesh& patch, const Improvement& how);

/// The least angle of each triangle, degrees.
std::vector<double> least_angles(const PatchMesh& patch);

}  // namespace burin
