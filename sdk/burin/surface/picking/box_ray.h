#pragma once
#include <burin/base/vector.h>
#include <burin/surface/picker.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

/// A ray prepared for tests against many boxes, by slabs.
class BoxRay {
 public:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Boxes are enlarged by 1e-12 of the extent of `whole`, which contains everything, well above the rounding
  /// of doubles (about 1e-16), so that rounding never makes the ray miss the box of an item that it meets.
  BoxRay(const Eigen::AlignedBox3f& whole, const Ray& ray) {
    const Vec3d origin = ray.origin.cast<double>();
    const double extent =
        std::max({origin.lpNorm<Eigen::Infinity>(), whole.min().cast<double>().lpNorm<Eigen::Infinity>(),
                  whole.max().cast<double>().lpNorm<Eigen::Infinity>()});
    for (int axis = 0; axis < 3; ++axis) {
      // A component of -0 counts as 0.
      const double along = ray.direction[axis], slack = along < 0 ? -1e-12 * extent : 1e-12 * extent;
      // A direction at right angles to the axis has a huge number, since infinity times 0 would be NaN.
      inverse_[axis] = along != 0 ? 1 / along : std::numeric_limits<double>::max();
      origin_in_[axis] = origin[axis] + slack;
      origin_out_[axis] = origin[axis] - slack;
    }
  }

  /// The distance at which the ray enters the box, in lengths of its direction, >= 0; infinite if it misses.
  double nearest(const Eigen::AlignedBox3f& box) const {
    double enter = 0, leave = infinity;
    for (int axis = 0; axis < 3; ++axis) {
      const bool up = inverse_[axis] >= 0;
      const double near = up ? box.min()[axis] : box.max()[axis],
                   far = up ? box.max()[axis] : box.min()[axis];
      enter = std::max(enter, (near - origin_in_[axis]) * inverse_[axis]);
      leave = std::min(leave, (far - origin_out_[axis]) * inverse_[axis]);
    }
    return enter <= leave ? enter : infinity;
  }

 private:
  Vec3d origin_in_, origin_out_, inverse_;
};

}  // namespace burin
