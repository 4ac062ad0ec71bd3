#pragma once
#include <burin/stroke/curve/surface_curve.h>

#include <cstddef>
#include <vector>

namespace burin {

/// The angle by which the tangent of a surface curve turns against parallel transport, radians, positive to
/// the left.
class TangentTurn {
 public:
  /// Updates the angles after a change of the curve from this point on (0: the whole curve).
  void update(const SurfaceCurve& curve, std::size_t first_changed = 0);

  /// From the first point to this one.
  double at(std::size_t point) const { return angles_[point]; }

  /// From the last point of a closed curve to its first.
  double closing() const { return closing_; }

  /// Along a whole closed curve, back to its first point.
  double loop() const { return angles_.empty() ? 0 : angles_.back() + closing_; }

 private:
  std::vector<double> angles_;  ///< [point]
  double closing_ = 0;
};

}  // namespace burin
