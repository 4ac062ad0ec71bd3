#pragma once
#include <burin/level_set/near_triangles.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <optional>

namespace burin {

/// The signed distance to a surface, negative on the inner side of its triangles, object units. Any thread,
/// concurrently. Surface and picker must outlive it.
class SurfaceDistance {
 public:
  SurfaceDistance(const Surface& surface, const Picker& picker) : surface_(&surface), picker_(&picker) {}

  double operator()(const Vec3d& p) const;

  /// `triangle`: one that is near the point, or no_index; becomes the closest one. The nearer it is, the
  /// faster; the result is the same.
  double operator()(const Vec3d& p, Index& triangle) const;

  /// The triangles among which the closest one is for all points within `radius` of a middle, whose distance
  /// is `distance`; nothing if they are more than `most`.
  std::optional<NearTriangles> around(const Vec3d& middle, double distance, double radius,
                                      std::size_t most) const;
  /// The same of triangles that were found around a larger ball.
  static NearTriangles around(const NearTriangles& larger, const Vec3d& middle, double distance,
                              double radius);

  /// The distance where the closest triangle is among `near`. `triangle`: as above, but one of `near`.
  double operator()(const Vec3d& p, const NearTriangles& near, Index& triangle) const;

  /// The distance near a point within reach, as linear.
  struct Linear {
    double value;
    Vec3d normal;  ///< unit, outward
  };
  std::optional<Linear> near(const Vec3d& p, double reach) const;

  /// The closest point of the surface, if there is one within reach.
  std::optional<Vec3d> closest(const Vec3d& p, double reach) const;

 private:
  Index descend(const Vec3d& p, Index triangle) const;
  double signed_distance(const Vec3d& p, Index triangle) const;

  const Surface* surface_;
  const Picker* picker_;
};

}  // namespace burin
