#pragma once
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/surface.h>

namespace burin {

/// Where a vertex of the surface stands on its base surface: its foot on the paraboloid of its cluster's
/// node. Any thread, concurrent, as BaseSurface.
Vec3f base_position(BaseSurface& base, const Surface& surface, Index vertex);

/// Mean of the normal curvatures of the base surface there, 1/length, positive where convex seen from
/// outside: the mean over the paraboloids around, so that it varies smoothly. As base_position.
float base_mean_curvature(BaseSurface& base, const Surface& surface, Index vertex);

}  // namespace burin
