#pragma once
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <span>

namespace burin {

/// Gathers the normal at a vertex from the corners of its faces: their normals weighted by the sine of the
/// angle at the vertex over the lengths of the edges there: exact for vertices on a sphere, and hardly moved
/// by slivers [Max 1999, Weights for Computing Vertex Normals from Facet Normals]. Degenerate corners count
/// for nothing.
class NormalSum {
 public:
  /// A corner, by its edges from the vertex to the next and to the previous vertex of the face. Its share is
  /// the cross product of the two over the squares of their lengths; in doubles products of any finite floats
  /// stay in range.
  void add(const Vec3d& edge, const Vec3d& next_edge) {
    const Vec3d cross = edge.cross(next_edge);
    const double squares = edge.squaredNorm() * next_edge.squaredNorm(), area = cross.squaredNorm();
    if (!(area > least_sine * least_sine * squares)) return;
    const double weight = 1 / squares;
    sum_ += weight * cross;
    squared_weights_ += weight * weight * area;
  }

  /// (0, 0, 1) where nothing is left.
  Vec3d unit() const;

 private:
  /// Below this sine of its corner a triangle's direction is rounding noise of its float corners.
  static constexpr double least_sine = 1e-6;

  Vec3d sum_ = Vec3d::Zero();
  double squared_weights_ = 0;  ///< the sum of the shares' squared lengths
};

/// Unit normal at a vertex of a surface whose vertices stand at `positions`: the NormalSum of its triangles.
Vec3f vertex_normal(const Surface& surface, std::span<const Vec3f> positions, Index vertex);

/// The same where there is no Surface, or its vertices stand elsewhere: `incident` as incident_triangles()
/// gives it, place(v) where vertex v stands.
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

/// The vertex normals interpolated to a point of the surface, unit.
Vec3f normal_at(const Surface& surface, const SurfacePoint& point);

}  // namespace burin
