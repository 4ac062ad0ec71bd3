#pragma once
#include <burin/surface/surface_point.h>

#include <optional>
#include <span>
#include <vector>

#include "region.h"
#include "unfolding.h"

namespace burin::test {

/// Geodesic distance inside the region, object units, from a point in one of its triangles to each of its
/// vertices: that of the polyhedron, exact up to rounding; infinite where no way leads. Nothing where an edge
/// has more than two triangles or two that disagree on its direction, and for a point outside the region.
std::optional<std::vector<double>> polyhedral_distances(const Surface& surface, const Region& region,
                                                        const SurfacePoint& from);

/// Geodesic distance inside the region from its vertices to a polyline of points of the surface. Exact at the
/// points; what lies between two of them is measured as if it lay in one plane with the vertex. Points
/// outside the region count for nothing. The region must outlive it.
class PolylineDistance {
 public:
  PolylineDistance(const Surface& surface, const Region& region, std::span<const SurfacePoint> points);

  /// Not where an edge has more than two triangles or two that disagree on its direction.
  bool is_known() const { return unfolding_.is_manifold(); }

  struct Nearest {
    double distance;  ///< object units
    double at;        ///< the point's number, with a fraction between it and the next
  };
  /// From a vertex of the surface in the region. A distance above `most` may be too long.
  Nearest from(Index vertex, double most);

 private:
  const Region& region_;
  Unfolding unfolding_;
  std::vector<double> lengths_;  ///< [point] to the next
};

}  // namespace burin::test
