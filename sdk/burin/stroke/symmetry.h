#pragma once
#include <burin/base/vector.h>

#include <cstdint>
#include <vector>

// The functions may be called on any thread, also on several at once.
namespace burin {

/// The symmetric images that are drawn with a stroke. Mirror planes and the axis of rotation pass through a
/// centre and are aligned with the axes of object space.
struct Symmetry {
  bool mirror_x = false, mirror_y = false,
       mirror_z = false;         ///< mirror at the plane perpendicular to the axis
  int radial = 1;                ///< copies around the axis, >= 1
  int axis = 1;                  ///< of rotation: 0 = x, 1 = y, 2 = z
  Vec3d centre = Vec3d::Zero();  ///< object units
};

/// One image of a stroke.
struct SymmetryInstance {
  Mat3d linear = Mat3d::Identity();
  Vec3d centre = Vec3d::Zero();
  std::uint32_t index = 0;  ///< 0 = the stroke as drawn
  bool mirrored = false;    ///< whether the image exchanges left and right

  Vec3d operator()(const Vec3d& place) const { return centre + linear * (place - centre); }
};

/// All different images in the order of their index: the combinations of mirrorings of the stroke as drawn (x
/// varies fastest, then y, then z), then these turned by one radial step, and so on. Throws ContractError for
/// fewer than one radial copy, an axis other than 0, 1, 2, a centre that is not finite, or more than 1024
/// images.
std::vector<SymmetryInstance> symmetry_instances(const Symmetry& symmetry);

}  // namespace burin
