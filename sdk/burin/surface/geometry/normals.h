#pragma once
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <span>

namespace burin {

/// Computes the normal at a vertex from the corners of its faces. Each face normal is weighted by the sine of
/// the corner's angle over the product of its edge lengths [Max 1999, Weights for Computing Vertex Normals
/// from Facet Normals]. The result is exact for vertices on a sphere, and slivers hardly influence it.
/// Degenerate corners are ignored.
class NormalSum {
 public:
  /// Adds a corner: its edges lead from the vertex to the next and to the previous vertex of the face. The
  /// contribution is their cross product over the product of their squared lengths. In doubles, products of
  /// any finite floats stay in range.
  void add(const Vec3d& edge, const Vec3d& next_edge) {
    const Vec3d cross = edge.cross(next_edge);
    const double squares = edge.squaredNorm() * next_edge.squaredNorm(), area = cross.squaredNorm();
    if (!(area > least_sine * least_sine * squares)) return;
    const double weight = 1 / squares;
    sum_ += weight * cross;
    squared_weights_ += weight * weight * area;
  }

  /// The unit normal; (0, 0, 1) if the contributions cancel out.
  Vec3d unit() const;

 private:
  /// Below this sine of the corner's angle the direction of a triangle is rounding noise of its float
  /// corners.
  static constexpr double least_sine = 1e-6;

  Vec3d sum_ = Vec3d::Zero();
  double squared_weights_ = 0;  ///< sum of the contributions' squared lengths
};

/// The unit normal at a vertex of a surface whose vertices are at `positions`: the NormalSum of its
/// triangles.
Vec3f vertex_normal(const Surface& surface, std::span<const Vec3f> positions, Index vertex);

/// The unit normal at a vertex without a Surface, or with other positions: `incident` is the result of
/// incident_triangles(), and place(v) returns the position of vertex v.
template <class Place>
Vec3f vertex_normal(std::span<const Triangle> triangles, const Csr& incident, Index vertex,
                    const Place& place) {
  const Vec3d here = place(vertex).template cast<double>();
  NormalSum sum;
  for (const Index index : incident[vertex]) {
    const Triangle& triangle = triangles[index];
    const std::size_t corner = corner_of(triangle, vertex);
    sum.add(place(triangle[(corner + 1) % 3]).template cast<double>() - here,
            place(triangle[(corner + 2) % 3]).template cast<double>() - here);
  }
  return sum.unit().template cast<float>();
}

/// Sets normals[v] for all v in `vertices`, in parallel.
void update_normals(const Surface& surface, std::span<const Vec3f> positions, std::span<const Index> vertices,
                    std::span<Vec3f> normals);

/// The unit normal at a point of the surface, interpolated from the vertex normals.
Vec3f normal_at(const Surface& surface, const SurfacePoint& point);

}  // namespace burin
