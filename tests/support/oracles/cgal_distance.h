#pragma once
#include <vector>

#include "region.h"

namespace burin::test {

/// Geodesic distances, object units, from the middle of a triangle of a manifold region to its vertices, as
/// CGAL computes them; below 0 where no way leads. Some are too long: see PolyhedralDistance's test.
std::vector<double> cgal_distances(const Surface& surface, const Region& region, Index local_triangle);

}  // namespace burin::test
