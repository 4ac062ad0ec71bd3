#pragma once
#include <burin/remesh/patch_mesh.h>

#include <optional>

namespace burin {

/// Joins two patches where their borders run along the same line, at most `tolerance` from each other, object
/// units, in opposite directions. Vertices of one border that have no partner in the other split its edges.
/// Sides with fixed vertices are no part of such lines. Returns nothing where a loop has no partner.
std::optional<PatchMesh> join(const PatchMesh& first, const PatchMesh& second, double tolerance);

}  // namespace burin
