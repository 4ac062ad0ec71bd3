#pragma once
#include <burin/remesh/patch_mesh.h>

#include <optional>

namespace burin {

/// The loops of a patch's border, without its sides that have a fixed vertex; each counter-clockwise around
/// the patch: its triangles lie to the left. From the vertex of the lowest number on, in the order of these
/// vertices. Throws Error where the border touches itself.
std::vector<std::vector<Index>> border_loops(const PatchMesh& patch);

/// Joins two patches where their borders run along the same line, at most `tolerance` from each other, object
/// units, in opposite directions. Vertices of one border that have no partner in the other split its edges.
/// Sides with fixed vertices are no part of such lines. Returns nothing where a loop has no partner.
std::optional<PatchMesh> join(const PatchMesh& first, const PatchMesh& second, double tolerance);

}  // namespace burin
