#pragma once
#include <burin/remesh/patch_mesh.h>

#include <map>
#include <utility>

namespace burin {

/// A side of a triangle, from one vertex to the next counter-clockwise.
using Side = std::pair<Index, Index>;

/// The sides of triangles that no other triangle has in the other direction, with the triangle's number.
std::map<Side, std::size_t> border_sides(const std::vector<Triangle>& triangles);

/// Vertices of a closed line.
using Loop = std::vector<Index>;

/// The loops of a patch's border, without its sides that have a fixed vertex; each counter-clockwise around
/// the patch: its triangles lie to the left. From the vertex of the lowest number on, in the order of these
/// vertices. Throws Error where the border touches itself.
std::vector<Loop> border_loops(const PatchMesh& patch);

}  // namespace burin
