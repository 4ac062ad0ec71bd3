// Computes vertex normals as sums over the triangles' corners [Max 1999], in O(valence) per vertex and on all
// threads.
#include <burin/base/parallel.h>
#include <burin/surface/geometry/normals.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr std::size_t vertices_per_block = 2048;

}  // namespace

Vec3d NormalSum::unit() const {
  const double squared = sum_.squaredNorm();
  // The normals of sheets that face each other cancel up to rounding; neither side is the outside.
  if (!(squared > 1e-12 * squared_weights_)) return Vec3d::UnitZ();
  return sum_ / std::sqrt(squared);
}

Vec3f vertex_normal(const Surface& surface, std::span<const Vec3f> positions, Index vertex) {
  return vertex_normal(surface.triangles, surface.incident, vertex,
                       [&](Index at) -> const Vec3f& { return positions[at]; });
}

void update_normals(const Surface& surface, std::span<const Vec3f> positions, std::span<const Index> vertices,
                    std::span<Vec3f> normals) {
  parallel_blocks(vertices.size(), vertices_per_block, [&](std::size_t begin, std::size_t end) {
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
