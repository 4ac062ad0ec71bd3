#include "flat_triangle.h"

#include <algorithm>

namespace burin::paper {
namespace {

FlatTriangle flat(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, bc = c - b, ca = a - c;
  const double length = ab.norm(), twice_area = ab.cross(-ca).norm();
  const double longest = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
  if (twice_area <= 1e-9 * longest) return {{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()}, {0, 0, 0}};
  const auto weight = [&](const Vec3d& in, const Vec3d& out) { return -in.dot(out) / (2 * twice_area); };
  return {{Vec2d(0, 0), Vec2d(length, 0), Vec2d(-ab.dot(ca) / length, twice_area / length)},
          {weight(bc, ca), weight(ca, ab), weight(ab, bc)}};
}

}  // namespace

std::vector<FlatTriangle> flatten(const Surface& surface, const test::Region& region) {
  const auto at = [&](Index v) { return surface.positions[region.vertices[v]].cast<double>(); };
  std::vector<FlatTriangle> triangles;
  for (const auto& [a, b, c] : region.corners) triangles.push_back(flat(at(a), at(b), at(c)));
  return triangles;
}

}  // namespace burin::paper
