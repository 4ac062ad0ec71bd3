#pragma once
#include <vector>

#include "region.h"

namespace burin::test {

/// Geodesic distances, object units, computed by CGAL, from the middle of a triangle of a manifold region to
/// the region's vertices; negative if there is no path. Some are too long: see the test of
/// PolyhedralDistance.
std::vector<double> cgal_distances(const Surface& surface, const Region& region, Index local_triangle);

}  // namespace burin::test
