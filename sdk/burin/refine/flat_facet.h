#pragma once
#include <burin/base/vector.h>

#include <array>
#include <optional>

namespace burin {

/// A triangle, prepared for searches of its point nearest to another one.
struct FlatFacet {
  /// One of its points.
  struct Place {
    std::array<double, 3> weights = {0, 0, 0};  ///< of the corners; their sum is 1, none is negative
    Vec3d at = Vec3d::Zero();                   ///< object units
  };

  explicit FlatFacet(const std::array<Vec3d, 3>& of);

  /// The foot of the perpendicular from a point, if that is in the triangle.
  std::optional<Place> foot(const Vec3d& point) const;

  /// A triangle without area counts as its sides.
  Place nearest(const Vec3d& point) const;

  std::array<Vec3d, 3> corners;                            ///< object units
  Vec3d along_b = Vec3d::Zero(), along_c = Vec3d::Zero();  ///< gradients of the weights of the last two
  bool has_area = false;
};

}  // namespace burin
