#pragma once
#include <burin/abi/ext/curve_filter.h>

#include <cstddef>
#include <string>
#include <vector>

#include "validate/probe/stroke.h"

namespace burin::validate {

/// Points of a straight curve on a plane, a tenth apart along t.
class StraightCurve {
 public:
  /// From t = 0 on.
  explicit StraightCurve(std::size_t count);
  StraightCurve(const StraightCurve&) = delete;
  StraightCurve& operator=(const StraightCurve&) = delete;

  const burin_curve_points& points() const { return points_; }

 private:
  std::vector<float> t_, zero_, one_;
  burin_curve_points points_{};
};

/// How a brush moves points of a curve of this length: along, then across. Throws Failed with `otherwise`
/// if it does not.
std::vector<float> offsets(const ProbeBrush& brush, const ProbeStroke& stroke,
                           const burin_curve_filter& filter, const burin_curve_points& points, double length,
                           const std::string& otherwise);

}  // namespace burin::validate
