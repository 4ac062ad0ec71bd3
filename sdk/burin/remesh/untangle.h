#pragma once
#include <burin/remesh/patch_mesh.h>

namespace burin {

/// Takes vertices of a mesh that were moved back to where they were before, object units, so that no triangle
/// is turned over or has lost its area against how it was then, and none goes through another one. Where they
/// did before, they still do.
void untangle(PatchMesh& mesh, const std::vector<Vec3d>& before);

}  // namespace burin
