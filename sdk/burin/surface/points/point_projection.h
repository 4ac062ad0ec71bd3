#pragma once
#include <burin/surface/points/point_tree.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <optional>
#include <vector>

namespace burin {

/// The smooth surface defined by oriented points, by moving least squares with normals [Alexa and Adamson
/// 2004; Kolluri 2005]. The height of a position x over it is the weighted mean of (n_i + n) / 2 . (x - p_i)
/// over the points p_i around x, where n is the mean of their normals n_i, and weights fall with distance.
/// The plane half way between two tangent planes holds the chord of the arc between them, so the height is
/// exact on planes, and up to the error of the mean on spheres and cylinders. Surface and tree must outlive
/// the object. May be used by several threads at once.
class PointProjection {
 public:
  PointProjection(const Surface& surface, const PointTree& tree) : surface_(surface), tree_(tree) {}

  /// The foot point of a position near the surface, searched from the closest point of the set. If no points
  /// surround the foot, beyond the border of the set, the result is that closest point.
  SurfacePoint foot(const Vec3d& place) const;

  /// The intersection of a line with the surface near `start`, by Newton's method. Returns nothing if there
  /// is none, or if no points surround it.
  std::optional<SurfacePoint> meet(const Vec3d& start, const Vec3d& direction) const;

 private:
  /// The local fit of the surface around a position.
  struct Fit {
    Vec3d normal;    ///< unit
    double height;   ///< height of the position over the surface, object units
    double support;  ///< radius within which points influence the fit, object units
    std::vector<PointTree::Near> points;
  };
  Fit fit(const Vec3d& place, const Vec3f& side) const;
  std::optional<SurfacePoint> surrounded(const Vec3d& place, const Fit& fit) const;
  SurfacePoint at_point(Index point) const;
  Index closest_point(const Vec3d& place) const;

  const Surface& surface_;
  const PointTree& tree_;
};

}  // namespace burin
