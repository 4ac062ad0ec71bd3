// The sign of a distance to triangles is that of the angle-weighted pseudonormal at the closest point [J. A.
// Baerentzen and H. Aanaes, Signed Distance Computation Using the Angle Weighted Pseudonormal, 2005].
#include <burin/level_set/surface_distance.h>
#include <burin/math/elementary.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/picking/closest_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

Vec3d edge(const Surface& surface, Index from, Index to) {
  return surface.positions[to].cast<double>() - surface.positions[from].cast<double>();
}

Vec3d triangle_normal(const Surface& surface, const Triangle& t) {
  return edge(surface, t[0], t[1]).cross(edge(surface, t[0], t[2])).stableNormalized();
}

Vec3d at_vertex(const Surface& surface, Index vertex) {
  Vec3d sum = Vec3d::Zero();
  for (const Index number : surface.incident[vertex]) {
    const Triangle& t = surface.triangles[number];
    const std::size_t corner = corner_of(t, vertex);
    const Vec3d a = edge(surface, vertex, t[(corner + 1) % 3]),
                b = edge(surface, vertex, t[(corner + 2) % 3]);
    sum += math::atan2(a.cross(b).norm(), a.dot(b)) * triangle_normal(surface, t);
  }
  return sum;
}

/// The sum of the normals of the triangles that have both vertices.
Vec3d at_edge(const Surface& surface, Index a, Index b) {
  Vec3d sum = Vec3d::Zero();
  for (const Index number : surface.incident[a]) {
    const Triangle& t = surface.triangles[number];
    if (std::ranges::find(t, b) != t.end()) sum += triangle_normal(surface, t);
  }
  return sum;
}

/// The pseudonormal at a point of a triangle, by which of its corners have a weight.
Vec3d pseudonormal(const Surface& surface, const Triangle& t, const std::array<double, 3>& weights) {
  constexpr double none = 1e-9;
  std::array<Index, 3> corners{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (weights[i] > none) corners[count++] = t[i];
  if (count == 1) return at_vertex(surface, corners[0]);
  if (count == 2) return at_edge(surface, corners[0], corners[1]);
  return triangle_normal(surface, t);
}

/// The closest point of a triangle, and the pseudonormal there.
struct Side {
  Vec3d foot, normal;
};

Side side_of(const Surface& surface, Index triangle, const Vec3d& p) {
  const TrianglePoint point = closest_point(surface, triangle, p);
  return {point.position,
          pseudonormal(surface, surface.triangles[triangle], {1 - point.u - point.v, point.u, point.v})};
}

/// How far from a middle the closest triangles are of points within `radius` of it: those are no farther from
/// the surface than `distance + radius`. With a margin for positions that are rounded to floats.
float reach_around(const Vec3d& middle, double distance, double radius) {
  constexpr double margin = 1e-6;
  const double reach = std::abs(distance) + 2 * radius;
  return static_cast<float>(reach + margin * (reach + middle.lpNorm<Eigen::Infinity>()));
}

}  // namespace

/// From one triangle to the nearest neighbours of its vertices again and again: the triangle that is nearest
/// then, of those around the last vertex and the first one.
Index SurfaceDistance::descend(const Vec3d& p, Index triangle) const {
  const auto from = [&](Index v) { return (surface_->positions[v].cast<double>() - p).squaredNorm(); };
  Index vertex = *std::ranges::min_element(surface_->triangles[triangle], {}, from);
  double nearest = from(vertex);
  for (Index at = no_index; at != vertex;) {
    at = vertex;
    for (const Index next : surface_->neighbours[at])
      if (const double to = from(next); to < nearest) {
        nearest = to;
        vertex = next;
      }
  }
  const auto to = [&](Index t) { return closest_point(*surface_, t, p).squared_distance; };
  double least = to(triangle);
  for (const Index other : surface_->incident[vertex])
    if (const double squared = to(other); squared < least) {
      least = squared;
      triangle = other;
    }
  return triangle;
}

double SurfaceDistance::signed_distance(const Vec3d& p, Index triangle) const {
  const Side side = side_of(*surface_, triangle, p);
  const double distance = (p - side.foot).norm();
  return side.normal.dot(p - side.foot) < 0 ? -distance : distance;
}

double SurfaceDistance::operator()(const Vec3d& p) const {
  Index triangle = no_index;
  return (*this)(p, triangle);
}

double SurfaceDistance::operator()(const Vec3d& p, Index& triangle) const {
  // The bound may be exceeded by rounding.
  constexpr double all = std::numeric_limits<float>::max(), more = 1.0001;
  const auto within = [&](double reach) {
    const std::optional<SurfacePoint> place = picker_->closest(p.cast<float>(), static_cast<float>(reach));
    return place ? place->triangle : no_index;
  };
  if (triangle != no_index) {
    const double squared = closest_point(*surface_, descend(p, triangle), p).squared_distance;
    triangle = within(more * std::sqrt(squared));
  }
  if (triangle == no_index) triangle = within(all);
  return signed_distance(p, triangle);
}

std::optional<NearTriangles> SurfaceDistance::around(const Vec3d& middle, double distance, double radius,
                                                     std::size_t most) const {
  auto triangles = picker_->near(middle.cast<float>(), reach_around(middle, distance, radius), most);
  if (!triangles) return {};
  return NearTriangles(*surface_, *triangles);
}

NearTriangles SurfaceDistance::around(const NearTriangles& larger, const Vec3d& middle, double distance,
                                      double radius) {
  return larger.within(middle.cast<float>(), reach_around(middle, distance, radius));
}

double SurfaceDistance::operator()(const Vec3d& p, const NearTriangles& near, Index& triangle) const {
  triangle = near.closest(p.cast<float>(), triangle);
  return signed_distance(p, triangle);
}

std::optional<SurfaceDistance::Linear> SurfaceDistance::near(const Vec3d& p, double reach) const {
  const std::optional<SurfacePoint> place = picker_->closest(p.cast<float>(), static_cast<float>(reach));
  if (!place) return {};
  const Side side = side_of(*surface_, place->triangle, p);
  const Vec3d normal = side.normal.stableNormalized();
  return Linear{normal.dot(p - side.foot), normal};
}

std::optional<Vec3d> SurfaceDistance::closest(const Vec3d& p, double reach) const {
  const std::optional<SurfacePoint> place = picker_->closest(p.cast<float>(), static_cast<float>(reach));
  if (!place) return {};
  return closest_point(*surface_, place->triangle, p).position;
}

}  // namespace burin
