// Combines changes by their extremes: along the normal by maximum and minimum, sideways by the Steiner point
// of the convex hull (Andrew's monotone chain). O(n log n) for n changes.
#include <burin/deform/blend/strongest.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace burin {
namespace {

/// Sideways parts below this share of a change are rounding of its frame.
constexpr double rounding = 1e-12;

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Appends half of the hull of points sorted along an axis, without its last corner.
template <class Points>
void append_half(const Points& sorted, std::vector<Vec2d>& hull) {
  const std::size_t first = hull.size();
  for (const Vec2d& point : sorted) {
    while (hull.size() >= first + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(point);
  }
  hull.pop_back();
}

/// The corners of the convex hull of these points, counterclockwise.
std::vector<Vec2d> hull_corners(std::vector<Vec2d> points) {
  std::ranges::sort(
      points, [](const Vec2d& a, const Vec2d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  std::vector<Vec2d> hull;
  append_half(points, hull);
  std::ranges::reverse(points);
  append_half(points, hull);
  return hull;
}

/// The Steiner point is the mean of the corners, each weighted by its exterior angle.
Vec2d twice_steiner_point(const std::vector<Vec2d>& corners) {
  Vec2d sum = Vec2d::Zero();
  for (std::size_t i = 0; i < corners.size() && corners.size() > 1; ++i) {
    const Vec2d& here = corners[i];
    const Vec2d before = here - corners[(i + corners.size() - 1) % corners.size()];
    const Vec2d after = corners[(i + 1) % corners.size()] - here;
    sum += std::abs(math::atan2(cross(before, after), before.dot(after))) / std::numbers::pi * here;
  }
  return sum;
}

}  // namespace

double strongest(std::span<const double> changes) {
  double highest = 0, deepest = 0;
  for (const double change : changes) {
    highest = std::max(highest, change);
    deepest = std::min(deepest, change);
  }
  return highest + deepest;
}

Vec3d strongest(std::span<const Vec3d> changes, const Vec3d& normal) {
  const Vec3d x = normal.unitOrthogonal(), y = normal.cross(x);
  double longest = 0;
  std::vector<double> up;
  up.reserve(changes.size());
  std::vector<Vec2d> level;
  for (const Vec3d& change : changes) {
    const Vec2d sideways(change.dot(x), change.dot(y));
    longest = std::max(longest, change.squaredNorm());
    up.push_back(change.dot(normal));
    if (sideways.squaredNorm() > rounding * rounding * change.squaredNorm()) level.push_back(sideways);
  }
  longest = std::sqrt(longest);
  Vec3d together = strongest(up) * normal;
  if (!level.empty()) {
    level.push_back(Vec2d::Zero());
    const Vec2d sideways = twice_steiner_point(hull_corners(std::move(level)));
    together += sideways.x() * x + sideways.y() * y;
  }
  const double length = together.norm();
  return length > longest ? Vec3d(longest / length * together) : together;
}

}  // namespace burin
