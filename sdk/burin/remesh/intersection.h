#pragma once
#include <burin/remesh/patch_mesh.h>

#include <optional>

namespace burin {

/// A corner of a triangle of the patch that goes through another one; nothing where there is none. Triangles
/// that share an edge, or touch without crossing, do not count. On all threads; the first such triangle,
/// whatever their number.
std::optional<Vec3d> self_intersection(const PatchMesh& patch);

}  // namespace burin
