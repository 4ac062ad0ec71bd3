#pragma once
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

namespace burin {

/// Whether a path over the surface joins two of its points near the chord between them: whether edges that
/// come within `reach` (object units) of the chord form a chain from the triangle of one point to that of the
/// other. The path may go farther from the chord by up to the length of an edge. On a point set links between
/// points take the place of edges. Costs in proportion to these edges.
bool has_path_near_chord(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to,
                         double reach);

}  // namespace burin
