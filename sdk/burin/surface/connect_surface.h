#pragma once
#include <burin/base/progress.h>
#include <burin/surface/surface.h>

namespace burin {

/// Computes what follows from the positions and triangles of a surface, which are sorted: neighbourhoods,
/// normals and curvature. `progress`, which may be empty, is told stages from `done` on. O(n) for meshes of
/// bounded valence, on all threads.
void connect_surface(Surface& surface, const Progress& progress = {}, double done = 0);

}  // namespace burin
