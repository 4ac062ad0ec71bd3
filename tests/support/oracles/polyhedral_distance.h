#pragma once
#include <burin/surface/surface_point.h>

#include <optional>
#include <span>
#include <vector>

#include "region.h"
#include "unfolding.h"

namespace burin::test {

/// Geodesic distances of the polyhedron, object units, inside the region from a point in one of its triangles
/// to each of its vertices: exact up to rounding; infinite if there is no path. Returns nothing if an edge
/// has more than two triangles or two that disagree on its direction, or if the point is outside the region.
std::optional<std::vector<double>> polyhedral_distances(const Surface& surface, const Region& region,
                                                        const SurfacePoint& from);

/// Geodesic distances inside the region from its vertices to a polyline of points of the surface. Distances
/// to the points are exact; between two points the segment is assumed to lie in one plane with the vertex.
/// Points outside the region are ignored. The region must outlive the object.
class PolylineDistance {
 public:
  PolylineDistance(const Surface& surface, const Region& region, std::span<const SurfacePoint> points);

  /// Whether distances can be computed: no edge has more than two triangles, or two that disagree on its
  /// direction.
  bool is_known() const { return unfolding_.is_manifold(); }

  struct Nearest {
    double distance;  ///< object units
    double at;        ///< index of the nearest point; a fraction lies between it and the next
  };
  /// The nearest point to a vertex of the surface in the region. A distance above `most` may be too long.
  Nearest from(Index vertex, double most);

 private:
  const Region& region_;
  Unfolding unfolding_;
  std::vector<double> lengths_;  ///< [point] distance to the next point
};

}  // namespace burin::test
