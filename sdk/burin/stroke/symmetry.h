#pragma once
#include <burin/base/vector.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Where else a stroke is drawn. Mirror planes and the axis of rotation go through a centre, in the axes of
/// object space.
struct Symmetry {
  bool mirror_x = false, mirror_y = false,
       mirror_z = false;         ///< across the plane at right angles to the axis
  int radial = 1;                ///< copies around the axis, >= 1
  int axis = 1;                  ///< of rotation: 0 = x, 1 = y, 2 = z
  Vec3d centre = Vec3d::Zero();  ///< object units
};

/// One image of a stroke.
struct SymmetryInstance {
  Mat3d linear = Mat3d::Identity();
  Vec3d centre = Vec3d::Zero();
  std::uint32_t index = 0;  ///< 0 = as drawn by hand
  bool mirrored = false;    ///< turns left into right

  Vec3d operator()(const Vec3d& place) const { return centre + linear * (place - centre); }
};

/// All images, by index: all mirrorings (x first, then y, then z, and their combinations) of the stroke as it
/// is drawn, then the same turned by one radial step, and so on; each image once. Throws ContractError for
/// fewer than one radial copy, an axis that there is not, a centre that is not finite, more than 1024 images.
std::vector<SymmetryInstance> symmetry_instances(const Symmetry& symmetry);

}  // namespace burin
