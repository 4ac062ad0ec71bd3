#pragma once
#include <burin/base/vector.h>
#include <burin/surface/triangle_mesh.h>

#include <cstdint>
#include <functional>

namespace burin::test {

/// A rectangle of the (u, v) plane divided into cells and mapped to space. Inner grid points are moved at
/// random, and the diagonals of cells are chosen at random. u x v points outward.
struct PatchGrid {
  double u_min = 0, u_max = 1, v_min = 0, v_max = 1;
  int cells_u = 1, cells_v = 1;
  bool wrap_u = false;                    ///< u_max is identified with u_min
  double jitter_u = 0.3, jitter_v = 0.3;  ///< greatest displacement of points, as a share of a cell
  std::uint32_t seed = 1;
};
TriangleMesh patch(const PatchGrid& grid, const std::function<Vec3d(double u, double v)>& map);

/// The square |x|, |y| <= half_width in the plane z = 0, normal +z.
TriangleMesh plane(double half_width, double edge, std::uint32_t seed);

/// The cylinder of this radius about the z axis, |z| <= half_length, open at the ends. Its vertices lie on
/// rulings that are `edge` apart, moved around the axis by at most `jitter` edges.
TriangleMesh cylinder(double radius, double half_length, double edge, double jitter, std::uint32_t seed);

/// The unit sphere: an icosahedron whose triangles are split into four `levels` times; then its vertices are
/// moved along the sphere by at most `jitter` mean edges.
TriangleMesh sphere(int levels, double jitter, std::uint32_t seed);

/// The mesh, with its middle at the origin and a diagonal of 4.
TriangleMesh fitted(TriangleMesh mesh);

/// The mesh with its vertices and triangles in random order.
TriangleMesh shuffled(const TriangleMesh& mesh, std::uint32_t seed);

}  // namespace burin::test
