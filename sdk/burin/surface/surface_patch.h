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

/// Puts a patch into a surface. Vertices that no triangle has any more are gone. Those that stay have the
/// order in source_vertex that they had; new ones come after them. Costs as much as make_surface().
PatchedSurface patched(const Surface& surface, const SurfacePatch& patch);

}  // namespace burin
