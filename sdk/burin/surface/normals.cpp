#include <burin/base/parallel.h>
#include <burin/surface/normals.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr std::size_t vertices_a_block = 2048;

/// Below this sine of its corner a triangle's direction is rounding noise of its float corners.
constexpr double least_sine = 1e-6;

/// The corner's share of the normal: the cross product of its two edges over the squares of their lengths.
/// In doubles products of any finite floats stay in range.
Vec3d weighted_normal(const Vec3d& edge, const Vec3d& next_edge) {
  const Vec3d cross = edge.cross(next_edge);
  const double squares = edge.squaredNorm() * next_edge.squaredNorm();
  if (!(cross.squaredNorm() > least_sine * least_sine * squares)) return Vec3d::Zero();
  return cross / squares;
}

}  // namespace

void NormalSum::add(const Vec3d& edge, const Vec3d& next_edge) {
  const Vec3d share = weighted_normal(edge, next_edge);
  sum_ += share;
  weights_ += share.norm();
}

Vec3d NormalSum::unit() const {
  const double length = sum_.norm();
  // Sheets that face each other cancel up to rounding: no side is the outside there.
  if (!(length > 1e-6 * weights_)) return Vec3d::UnitZ();
  return sum_ / length;
}

Vec3f vertex_normal(const Surface& surface, std::span<const Vec3f> positions, Index vertex) {
  return vertex_normal(surface.triangles, surface.incident, vertex,
                       [&](Index at) -> const Vec3f& { return positions[at]; });
}

void update_normals(const Surface& surface, std::span<const Vec3f> positions, std::span<const Index> vertices,
                    std::span<Vec3f> normals) {
  parallel_blocks(vertices.size(), vertices_a_block, [&](std::size_t begin, std::size_t end) {
    for (const Index vertex : vertices.subspan(begin, end - begin))
      normals[vertex] = vertex_normal(surface, positions, vertex);
  });
}

Vec3f normal_at(const Surface& surface, const SurfacePoint& point) {
  Vec3f normal = Vec3f::Zero();
  for (std::size_t i = 0; i < 3; ++i) normal += point.weights[i] * surface.normals[point.corners[i]];
  const float length = normal.norm();
  return length > 1e-6F ? Vec3f(normal / length) : surface.normals[point.corners[0]];
}

}  // namespace burin
