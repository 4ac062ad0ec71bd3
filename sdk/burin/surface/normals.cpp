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

/// Angle of a right triangle with these legs, sine >= 0. Scaled first so that floats suffice.
double angle_of(double sine, double cosine) {
  const double scale = 1 / std::max(sine, std::abs(cosine));
  return std::atan2(static_cast<float>(sine * scale), static_cast<float>(cosine * scale));
}

/// The triangle's unit normal times its angle at the corner between the two edges. In doubles products of
/// any finite floats stay in range.
Vec3d weighted_normal(const Vec3d& edge, const Vec3d& next_edge) {
  const Vec3d cross = edge.cross(next_edge);
  const double square = cross.squaredNorm();
  if (!(square > least_sine * least_sine * edge.squaredNorm() * next_edge.squaredNorm()))
    return Vec3d::Zero();
  const double sine = std::sqrt(square);
  return cross * (angle_of(sine, edge.dot(next_edge)) / sine);
}

/// Position of the vertex among the triangle's corners.
int corner_of(const Triangle& triangle, Index vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

}  // namespace

Vec3f vertex_normal(const Surface& surface, std::span<const Vec3f> positions, Index vertex) {
  const Vec3d here = positions[vertex].cast<double>();
  Vec3d sum = Vec3d::Zero();
  for (const Index index : surface.incident[vertex]) {
    const Triangle& triangle = surface.triangles[index];
    const int corner = corner_of(triangle, vertex);
    const Vec3d edge = positions[triangle[(corner + 1) % 3]].cast<double>() - here;
    const Vec3d next_edge = positions[triangle[(corner + 2) % 3]].cast<double>() - here;
    sum += weighted_normal(edge, next_edge);
  }
  const double length = sum.norm();
  // Sheets that face each other cancel up to rounding: no side is the outside there.
  if (!(length > 1e-6)) return Vec3f::UnitZ();
  return (sum / length).cast<float>();
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
