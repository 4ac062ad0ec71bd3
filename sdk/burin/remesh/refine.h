#pragma once
#include <burin/remesh/patch_mesh.h>

namespace burin {

/// Halves edges that are longer than what `size` says at their ends and along them, the longest first, until
/// there is none, except beside longer edges of the border, which stay. The surface stays as it is.
void refine(PatchMesh& patch, const PointField& size);

/// The least of `size` along the line between two points, at fifths of it.
double least_size(const PointField& size, const Vec3d& from, const Vec3d& to);

}  // namespace burin
