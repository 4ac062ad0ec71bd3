#pragma once
#include <burin/remesh/patch_mesh.h>

#include <vector>

namespace burin {

/// The triangles of the patch that go through another one, ascending. Triangles that share an edge, or touch
/// without crossing, do not count. On all threads.
std::vector<Index> crossing_triangles(const PatchMesh& patch);

}  // namespace burin
