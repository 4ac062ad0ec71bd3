#pragma once
#include <burin/surface/surface_point.h>

#include <optional>
#include <vector>

#include "support/region.h"

namespace burin::test {

/// Geodesic distance inside the region, object units, from a point in one of its triangles to each of its
/// vertices: that of the polyhedron, exact up to rounding; infinite where no way leads. Nothing where an edge
/// has more than two triangles or two that disagree on its direction, and for a point outside the region.
std::optional<std::vector<double>> polyhedral_distances(const Surface& surface, const Region& region,
                                                        const SurfacePoint& from);

}  // namespace burin::test
