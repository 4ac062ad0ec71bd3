// Computes closest points of triangles in doubles, by the Voronoi regions of corners and edges [Ericson
// 2005].
#include <burin/base/segment.h>
#include <burin/surface/picking/closest_point.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace burin {
namespace {

struct Corners {
  Vec3d a, b, c;
};

Corners corners_of(const Surface& surface, Index triangle) {
  const Triangle& corners = surface.triangles[triangle];
  return {surface.positions[corners[0]].cast<double>(), surface.positions[corners[1]].cast<double>(),
          surface.positions[corners[2]].cast<double>()};
}

/// Barycentric interpolation, exact at the corners.
Vec3d blend(const Corners& t, double u, double v) { return (1 - u - v) * t.a + u * t.b + v * t.c; }

TrianglePoint point_at(const Corners& t, const Vec3d& query, double u, double v) {
  const Vec3d position = blend(t, u, v);
  return {u, v, position, (position - query).squaredNorm()};
}

TrianglePoint closest_on_edges(const Corners& t, const Vec3d& query) {
  const double ab = share_on_segment(t.a, t.b, query);
  const double ac = share_on_segment(t.a, t.c, query);
  const double bc = share_on_segment(t.b, t.c, query);
  return std::min({point_at(t, query, ab, 0), point_at(t, query, 0, ac), point_at(t, query, 1 - bc, bc)},
                  [](const auto& x, const auto& y) { return x.squared_distance < y.squared_distance; });
}

}  // namespace

// The closest point follows from the Voronoi region of the triangle that holds the query [C. Ericson,
// Real-Time Collision Detection, 2005, section 5.1.5]. Corners come out exact, so that all triangles around a
// vertex are equally close to it.
TrianglePoint closest_point(const Surface& surface, Index triangle, const Vec3d& query) {
  const Corners t = corners_of(surface, triangle);
  const Vec3d ab = t.b - t.a, ac = t.c - t.a;
  const Vec3d from_a = query - t.a, from_b = query - t.b, from_c = query - t.c;
  const double ab_a = ab.dot(from_a), ac_a = ac.dot(from_a);
  if (ab_a <= 0 && ac_a <= 0) return point_at(t, query, 0, 0);
  const double ab_b = ab.dot(from_b), ac_b = ac.dot(from_b);
  if (ab_b >= 0 && ac_b <= ab_b) return point_at(t, query, 1, 0);
  const double ab_c = ab.dot(from_c), ac_c = ac.dot(from_c);
  if (ac_c >= 0 && ab_c <= ac_c) return point_at(t, query, 0, 1);
  const double beyond_ab = ab_a * ac_b - ab_b * ac_a;
  const double beyond_ac = ab_c * ac_a - ab_a * ac_c;
  const double beyond_bc = ab_b * ac_c - ab_c * ac_b;
  if (beyond_ab <= 0 || beyond_ac <= 0 || beyond_bc <= 0) return closest_on_edges(t, query);
  const double whole = beyond_ab + beyond_ac + beyond_bc;
  return point_at(t, query, beyond_ac / whole, beyond_ab / whole);
}

SurfacePoint point_on(const Surface& surface, Index triangle, double u, double v) {
  return {triangle,
          surface.triangles[triangle],
          {static_cast<float>(1 - u - v), static_cast<float>(u), static_cast<float>(v)},
          blend(corners_of(surface, triangle), u, v).cast<float>()};
}

}  // namespace burin
