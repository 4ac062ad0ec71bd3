#pragma once
#include <burin/base/trees/box_lanes.h>
#include <burin/base/vector.h>
#include <burin/surface/picker.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

/// A ray prepared for tests against many boxes, by slabs. Floats suffice, since a difference of floats, an
/// inverse and a product are each off by 2^-24 of themselves at most: bounds with a margin above the three
/// together never miss a box that the ray meets within 3e38 lengths of its direction.
class BoxRay {
 public:
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  /// Boxes are enlarged by 1e-12 of the extent of `whole`, which contains everything, so that the ray meets
  /// boxes without thickness that it lies in.
  BoxRay(const Eigen::AlignedBox3f& whole, const Ray& ray) : origin_(ray.origin) {
    const float extent =
        std::max({ray.origin.lpNorm<Eigen::Infinity>(), whole.min().lpNorm<Eigen::Infinity>(),
                  whole.max().lpNorm<Eigen::Infinity>()});
    slack_ = 1e-12F * extent;
    // Of a direction as long as about 1, inverses do not overflow where the ray meets anything.
    const int exponent = std::clamp(std::ilogb(ray.direction.lpNorm<Eigen::Infinity>()), -100, 100);
    length_ = std::ldexp(1.F, -exponent);
    for (int axis = 0; axis < 3; ++axis) {
      const float along = std::ldexp(ray.direction[axis], -exponent);
      // A direction at right angles to the axis has a huge number, since infinity times 0 would be NaN.
      inverse_[axis] = std::abs(along) > least ? 1 / along : std::copysign(1 / least, along);
    }
  }

  /// The distances at which the ray enters boxes, in lengths of its direction, >= 0, at most 1e-6 of them too
  /// near; infinite where it misses.
  BoxLanes::Lane nearest(const BoxLanes& boxes) const {
    using Lane = BoxLanes::Lane;
    Lane enter = Lane::Zero(), leave = Lane::Constant(std::numeric_limits<float>::max());
    for (int axis = 0; axis < 3; ++axis) {
      const bool up = inverse_[axis] > 0;
      const Lane &near = up ? boxes.low(axis) : boxes.high(axis),
                 &far = up ? boxes.high(axis) : boxes.low(axis);
      const float slack = up ? slack_ : -slack_;
      enter = enter.max((near - origin_[axis] - slack) * inverse_[axis]);
      leave = leave.min((far - origin_[axis] + slack) * inverse_[axis]);
    }
    constexpr float margin = 5e-7F;
    return ((1 - margin) * enter <= (1 + margin) * leave)
        .select((1 - margin) * length_ * enter, Lane::Constant(infinity));
  }

 private:
  static constexpr float least = 1e-37F;

  Vec3f origin_, inverse_;
  float slack_;
  float length_;  ///< of the ray's direction, in those of the one by which is divided here
};

}  // namespace burin
