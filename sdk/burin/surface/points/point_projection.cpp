// Projects positions onto the implicit surface of a point set. Each iteration costs one search for the
// nearest points, O(log n), and there are at most 24 iterations.
#include <burin/surface/points/point_projection.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr std::size_t points_a_fit = 12;
constexpr int most_iterations = 24;

/// A step below this share of the support ends the iterations; floats cannot resolve less.
constexpr double small_step = 1e-7;

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The squared radius of the circle through the corners.
double circumradius2(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const double doubled_area = cross(b - a, c - a);
  return (b - a).squaredNorm() * (c - b).squaredNorm() * (a - c).squaredNorm() /
         (4 * doubled_area * doubled_area);
}

/// The barycentric coordinates of the origin, or nothing if it lies outside the triangle.
std::optional<std::array<double, 3>> weights_at_origin(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const std::array<double, 3> parts = {cross(b, c), cross(c, a), cross(a, b)};
  const double whole = parts[0] + parts[1] + parts[2];
  if (whole == 0) return std::nullopt;
  const std::array<double, 3> weights = {parts[0] / whole, parts[1] / whole, parts[2] / whole};
  // A point of the set lies on a corner of its triangles, up to rounding.
  if (std::ranges::min(weights) < -1e-9) return std::nullopt;
  return weights;
}

}  // namespace

PointProjection::Fit PointProjection::fit(const Vec3d& place, const Vec3f& side) const {
  std::vector<PointTree::Near> near;
  tree_.nearest(place, 2 * points_a_fit, near);
  Fit fit;
  keep_facing(near, surface_.normals, side, points_a_fit, fit.points);
  const double squared_support = fit.points.empty() ? 0 : fit.points.back().squared_distance;
  fit.support = std::sqrt(squared_support);

  const auto weight = [squared_support](const PointTree::Near& point) {
    // The weight is not quite 0 at the support, since all points may lie on it.
    const double inside = squared_support > 0 ? 1.001 - point.squared_distance / squared_support : 1;
    return inside * inside;
  };
  double weights = 0;
  Vec3d normals = Vec3d::Zero();
  for (const PointTree::Near& point : fit.points) {
    weights += weight(point);
    normals += weight(point) * surface_.normals[point.point].cast<double>();
  }
  fit.normal = normals.norm() > 1e-6 * weights ? normals.normalized() : Vec3d(side.cast<double>());
  double height = 0;
  for (const PointTree::Near& point : fit.points) {
    const Vec3d away = place - surface_.positions[point.point].cast<double>();
    height += weight(point) * (surface_.normals[point.point].cast<double>() + fit.normal).dot(away) / 2;
  }
  fit.height = weights > 0 ? height / weights : 0;
  return fit;
}

Index PointProjection::closest_point(const Vec3d& place) const {
  std::vector<PointTree::Near> near;
  tree_.nearest(place, 1, near);
  return near[0].point;
}

SurfacePoint PointProjection::foot(const Vec3d& place) const {
  const Index closest = closest_point(place);
  const Vec3f& side = surface_.normals[closest];
  Vec3d x = surface_.positions[closest].cast<double>();
  Fit at_x = fit(x, side);
  for (int i = 0; i < most_iterations; ++i) {
    // The step leads toward the orthogonal foot of the position on the plane through the surface below x.
    const Vec3d below = x - at_x.height * at_x.normal;
    const Vec3d step = place - at_x.normal.dot(place - below) * at_x.normal - x;
    const double length = step.norm();
    x += length > at_x.support ? Vec3d(at_x.support / length * step) : step;
    at_x = fit(x, side);
    if (length <= small_step * at_x.support) break;
  }
  x -= at_x.height * at_x.normal;
  return surrounded(x, at_x).value_or(at_point(closest));
}

std::optional<SurfacePoint> PointProjection::meet(const Vec3d& start, const Vec3d& direction) const {
  const Vec3f& side = surface_.normals[closest_point(start)];
  const Vec3d along = direction.normalized();
  Vec3d x = start;
  for (int i = 0; i < most_iterations; ++i) {
    const Fit at_x = fit(x, side);
    const double slope = at_x.normal.dot(along);
    if (std::abs(at_x.height) <= small_step * at_x.support) return surrounded(x, at_x);
    if (std::abs(at_x.height) > 2 * at_x.support * std::abs(slope)) return std::nullopt;
    x -= at_x.height / slope * along;
  }
  return std::nullopt;
}

/// Expresses a position by three of the fit's points: the triangle around it, in the plane of the fit, with
/// the smallest circumscribed circle. Returns nothing if no triangle holds the position.
std::optional<SurfacePoint> PointProjection::surrounded(const Vec3d& place, const Fit& fit) const {
  const Vec3d e1 = fit.normal.unitOrthogonal(), e2 = fit.normal.cross(e1);
  std::vector<Vec2d> flat;
  for (const PointTree::Near& point : fit.points) {
    const Vec3d away = surface_.positions[point.point].cast<double>() - place;
    flat.emplace_back(away.dot(e1), away.dot(e2));
  }
  SurfacePoint best;
  double least = fit.support * fit.support;
  for (std::size_t a = 0; a < flat.size(); ++a) {
    for (std::size_t b = a + 1; b < flat.size(); ++b) {
      for (std::size_t c = b + 1; c < flat.size(); ++c) {
        const auto weights = weights_at_origin(flat[a], flat[b], flat[c]);
        if (!weights) continue;
        const double radius2 = circumradius2(flat[a], flat[b], flat[c]);
        if (radius2 >= least) continue;
        least = radius2;
        best.corners = {fit.points[a].point, fit.points[b].point, fit.points[c].point};
        std::ranges::transform(*weights, best.weights.begin(),
                               [](double weight) { return static_cast<float>(std::max(weight, 0.)); });
      }
    }
  }
  if (best.corners[0] == no_index) return std::nullopt;
  best.position = place.cast<float>();
  return best;
}

/// A point of the set. Two of its neighbours are corners with weight 0, so that the spacing of the points can
/// be read from the result.
SurfacePoint PointProjection::at_point(Index point) const {
  SurfacePoint at{no_index, {point, point, point}, {1, 0, 0}, surface_.positions[point]};
  const auto neighbours = surface_.neighbours[point];
  for (std::size_t i = 0; i < 2 && i < neighbours.size(); ++i) at.corners[i + 1] = neighbours[i];
  return at;
}

}  // namespace burin
