// Gauss curvature as the ratio of the area that normals sweep on the unit sphere to the area of the surface
// (the Gauss map); for point sets, from a least-squares fit of the shape operator. Each vertex costs
// O(valence).
#include <burin/base/parallel.h>
#include <burin/surface/geometry/curvature.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <cstddef>

namespace burin {

namespace {

float swept_over_area(const Surface& surface, Index vertex) {
  const Vec3f& normal = surface.normals[vertex];
  float swept = 0, area = 0;
  for (const Index triangle : surface.incident[vertex]) {
    const auto doubled = [&, &t = surface.triangles[triangle]](const std::vector<Vec3f>& at) {
      return (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]).dot(normal);
    };
    swept += doubled(surface.normals);
    area += doubled(surface.positions);
  }
  return area > 0 ? swept / area : 0;
}

/// The determinant of the symmetric map of the tangent plane that best fits, in the least-squares sense, the
/// changes of the normal along the edges to the neighbours. All edges have the same weight.
float fitted_determinant(const Surface& surface, Index vertex) {
  const Vec3f& normal = surface.normals[vertex];
  const Vec3f e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Index neighbour : surface.neighbours[vertex]) {
    const Vec3f edge = surface.positions[neighbour] - surface.positions[vertex];
    const Vec3f bend = surface.normals[neighbour] - normal;
    const double x = edge.dot(e1), y = edge.dot(e2), squared = x * x + y * y;
    if (!(squared > 0)) continue;
    const Eigen::Matrix<double, 2, 3> rows{{x, y, 0}, {0, x, y}};
    squares += rows.transpose() * rows / squared;
    right += rows.transpose() * Eigen::Vector2d(bend.dot(e1), bend.dot(e2)) / squared;
  }
  const double size = squares.trace();
  if (!(std::abs(squares.determinant()) > 1e-9 * size * size * size)) return 0;
  const Eigen::Vector3d map = squares.ldlt().solve(right);
  return static_cast<float>(map[0] * map[2] - map[1] * map[1]);
}

}  // namespace

float gauss_curvature(const Surface& surface, Index vertex) {
  return surface.is_point_set() ? fitted_determinant(surface, vertex) : swept_over_area(surface, vertex);
}

void update_gauss_curvature(Surface& surface, std::span<const Index> vertices) {
  constexpr std::size_t vertices_per_block = 2048;
  parallel_blocks(vertices.size(), vertices_per_block, [&](std::size_t begin, std::size_t end) {
    for (const Index vertex : vertices.subspan(begin, end - begin))
      surface.gauss_curvature[vertex] = gauss_curvature(surface, vertex);
  });
}

void compute_gauss_curvature(Surface& surface) {
  constexpr std::size_t vertices_per_block = 16384;
  surface.gauss_curvature.resize(surface.positions.size());
  parallel_blocks(surface.positions.size(), vertices_per_block, [&](std::size_t begin, std::size_t end) {
    for (Index vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      surface.gauss_curvature[vertex] = gauss_curvature(surface, vertex);
  });
}

}  // namespace burin
