#pragma once
#include <burin/surface/points/point_tree.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <optional>
#include <vector>

namespace burin {

/// The smooth surface that oriented points stand for: moving least squares with their normals. The height of
/// a place x over it is the mean of (n_i + n) / 2 . (x - p_i) over the points p_i around, n the mean of their
/// normals n_i, weighted by distance. Half way between two tangent planes lies the plane that holds the chord
/// of an arc: exact on planes, and but for the mean's own error on spheres and cylinders.
/// [Alexa and Adamson 2004; Kolluri 2005.] Surface and tree must outlive it. Any thread, concurrent.
class PointProjection {
 public:
  PointProjection(const Surface& surface, const PointTree& tree) : surface_(surface), tree_(tree) {}

  /// The foot of a place near the surface, found from the point closest to it. Where no points surround the
  /// foot, beyond the border of the set, that closest point itself.
  SurfacePoint foot(const Vec3d& place) const;

  /// Where a line meets the surface near `start`, found by Newton's method; nothing where it does not, or
  /// where no points surround the place.
  std::optional<SurfacePoint> meet(const Vec3d& start, const Vec3d& direction) const;

 private:
  /// The surface as seen from a place.
  struct Fit {
    Vec3d normal;    ///< unit
    double height;   ///< of the place over the surface
    double support;  ///< radius around the place whose points have a say
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
