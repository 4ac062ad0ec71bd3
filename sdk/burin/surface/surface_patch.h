#pragma once
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// A surface with a patch.
struct PatchedSurface {
  Surface surface;
  std::vector<Index> came_from;  ///< [vertex] its number before, or from the old vertex_count() on the new
                                 ///< vertex
};

/// Puts a patch into a surface. Vertices that no triangle has any more are gone. Vertices and triangles that
/// stay keep their order, also that in source_vertex; new ones come after them, near ones together. Costs
/// O(n) of copying, and what make_surface() does for the patch. Throws Error where a new position is not
/// finite or no triangle is left.
PatchedSurface patched(const Surface& surface, const SurfacePatch& patch);

}  // namespace burin
