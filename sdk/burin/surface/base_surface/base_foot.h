#pragma once
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/surface.h>

namespace burin {

/// The position of a vertex's foot point on its base surface, on the paraboloid of its cluster's node. May be
/// called from several threads at once.
Vec3f base_position(BaseSurface& base, const Surface& surface, Index vertex);

/// The mean curvature of the base surface at a vertex's foot point, 1 / length, positive where convex seen
/// from outside. It is averaged over the paraboloids around the point, so that it varies smoothly. May be
/// called from several threads at once.
float base_mean_curvature(BaseSurface& base, const Surface& surface, Index vertex);

}  // namespace burin
