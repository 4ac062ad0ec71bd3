#pragma once
#include <burin/stroke/stroke_settings.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <Eigen/Geometry>
#include <vector>

namespace burin {

/// A mesh that is to be bent, turned so that x runs along the stroke, y across it to the left and z up; in
/// units of the mesh.
struct SourcePart {
  std::vector<Vec3d> points;
  std::vector<Triangle> triangles;
  std::vector<TriangleUv> triangle_uv;  ///< [triangle], or empty
  Eigen::AlignedBox3d box;              ///< of the points that triangles have

  /// Throws Error if no triangle is left of the mesh, or it has no extent along the stroke.
  SourcePart(const PolygonMesh& mesh, const AlongSettings& axes);

  double length() const { return box.sizes().x(); }

  /// How far along a point lies, from 0 to 1; exactly 0 and 1 at the ends.
  double share(const Vec3d& point) const { return (point.x() - box.min().x()) / length(); }
};

}  // namespace burin
