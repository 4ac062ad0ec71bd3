#pragma once
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

namespace burin {

/// The point of a triangle that is closest to a query: u * corner 1 + v * corner 2 + (1 - u - v) * corner 0.
struct TrianglePoint {
  double u, v;
  Vec3d position;
  double squared_distance;
};

/// The point of the triangle closest to `query`. A triangle without area counts as its edges.
TrianglePoint closest_point(const Surface& surface, Index triangle, const Vec3d& query);

/// The point u * corner 1 + v * corner 2 + (1 - u - v) * corner 0 of a triangle, at the current positions.
SurfacePoint point_on(const Surface& surface, Index triangle, double u, double v);

}  // namespace burin
