#pragma once
#include <burin/base/vector.h>

#include <algorithm>
#include <map>

namespace burin {

/// The range of an axis of a tablet, as its driver tells it.
struct EvdevAxis {
  double least = 0, most = 0;
  double resolution = 0;  ///< values per mm, or per radian; 0: unknown
};

using EvdevAxes = std::map<unsigned, EvdevAxis>;  ///< by the code of the axis

/// An axis whose range is known, or null.
inline const EvdevAxis* axis_of(const EvdevAxes& axes, unsigned code) {
  const auto found = axes.find(code);
  return found != axes.end() && found->second.most > found->second.least ? &found->second : nullptr;
}

/// Where a value is in the range of an axis, 0 to 1.
inline double share_of(const EvdevAxis& axis, double value) {
  return std::clamp((value - axis.least) / (axis.most - axis.least), 0., 1.);
}

/// Two axes of positions: millimetres from the left and top where the device tells them, else its own units.
class EvdevPlane {
 public:
  EvdevPlane(const EvdevAxes& axes, unsigned x, unsigned y) : x_(axis_of(axes, x)), y_(axis_of(axes, y)) {}

  bool has_millimetres() const { return x_ && y_ && x_->resolution > 0 && y_->resolution > 0; }

  Vec3d position(double x, double y) const {
    if (!has_millimetres()) return {x, y, 0};
    return {(x - x_->least) / x_->resolution, (y - y_->least) / y_->resolution, 0};
  }

 private:
  const EvdevAxis *x_, *y_;
};

}  // namespace burin
