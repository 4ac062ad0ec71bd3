// Computes the frames of a mesh with texture coordinates: vertex normals, and for each corner the direction
// of the mean dP/du of the triangles around the vertex in its island, weighted by their areas in texture
// space. Costs O(n) on all threads.
#include <burin/base/parallel.h>
#include <burin/deform/bake/base_frames.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/topology/adjacency.h>

#include <Eigen/Geometry>

namespace burin {
namespace {

constexpr std::size_t elements_per_block = 8192;
constexpr double least_square = 1e-12;  ///< shorter means of unit vectors (squared length) have no direction

/// Twice the area of a triangle in texture space; negative if the triangle is mirrored there.
double doubled_area(const TriangleUv& uv) {
  const Vec2d along = (uv[1] - uv[0]).cast<double>(), across = (uv[2] - uv[0]).cast<double>();
  return along.x() * across.y() - along.y() * across.x();
}

/// dP/du of a triangle times twice its area in texture coordinates.
Vec3d weighted_tangent(const TriangleMesh& mesh, Index index) {
  const Triangle& triangle = mesh.triangles[index];
  const TriangleUv& uv = mesh.triangle_uv[index];
  const auto side = [&](std::size_t corner) -> Vec3d {
    return mesh.positions[triangle[corner]].cast<double>() - mesh.positions[triangle[0]].cast<double>();
  };
  const auto rise = [&](std::size_t corner) { return static_cast<double>(uv[corner].y() - uv[0].y()); };
  const Vec3d tangent = side(1) * rise(2) - side(2) * rise(1);
  return doubled_area(uv) < 0 ? Vec3d(-tangent) : tangent;
}

/// Interpolates a function of the corner to a point of the triangle.
template <class AtCorner>
Vec3d interpolated(const Vec3d& weights, const AtCorner& at_corner) {
  return weights[0] * at_corner(0) + weights[1] * at_corner(1) + weights[2] * at_corner(2);
}

}  // namespace

BaseFrames::BaseFrames(const TriangleMesh& base, bool tangents)
    : base_(base),
      incident_(incident_triangles(base.positions.size(), base.triangles)),
      normals_(base.positions.size()),
      tangents_(tangents ? base.triangles.size() : 0) {
  parallel_blocks(normals_.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (Index vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      normals_[vertex] = vertex_normal(base.triangles, incident_, vertex,
                                       [&](Index at) -> const Vec3f& { return base.positions[at]; });
  });
  parallel_blocks(tangents_.size(), elements_per_block, [&](std::size_t begin, std::size_t end) {
    for (Index triangle = static_cast<Index>(begin); triangle < end; ++triangle)
      tangents_[triangle] = {tangent(triangle, 0), tangent(triangle, 1), tangent(triangle, 2)};
  });
}

Vec3d BaseFrames::normal(Index triangle, const Vec3d& weights) const {
  const auto at_corner = [&](std::size_t corner) -> Vec3d {
    return normals_[base_.triangles[triangle][corner]].cast<double>();
  };
  const Vec3d sum = interpolated(weights, at_corner);
  return sum.squaredNorm() > least_square ? sum.normalized() : at_corner(0);
}

Eigen::Matrix3d BaseFrames::frame(Index triangle, const Vec3d& weights) const {
  const Vec3d n = normal(triangle, weights);
  const Vec3d sum = interpolated(
      weights, [&](std::size_t corner) -> Vec3d { return tangents_[triangle][corner].cast<double>(); });
  const Vec3d across = sum - sum.dot(n) * n;
  const Vec3d t = across.squaredNorm() > least_square ? across.normalized() : n.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame << t.transpose(), n.cross(t).transpose(), n.transpose();
  return frame;
}

Vec3f BaseFrames::tangent(Index triangle, std::size_t corner) const {
  const Index vertex = base_.triangles[triangle][corner];
  const TriangleUv& uv = base_.triangle_uv[triangle];
  Vec3d sum = Vec3d::Zero();
  for (const Index other : incident_[vertex]) {
    const TriangleUv& other_uv = base_.triangle_uv[other];
    const bool mirrored = (doubled_area(uv) < 0) != (doubled_area(other_uv) < 0);
    if (!mirrored && other_uv[corner_of(base_.triangles[other], vertex)] == uv[corner])
      sum += weighted_tangent(base_, other);
  }
  return sum.stableNormalized().cast<float>();
}

}  // namespace burin
