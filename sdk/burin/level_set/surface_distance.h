#pragma once
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
