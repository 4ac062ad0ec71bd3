#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "bench/power_law.h"
#include "bench/result.h"

namespace burin {

/// The growth of one cost along one axis of a suite.
struct Scaling {
  ScalingAxis axis = ScalingAxis::none;
  std::string cost;  ///< "stroke", "event p95" or "stroke end p50"
  std::vector<std::string> cases;
  std::vector<double> sizes;  ///< vertices that the stroke reaches (region axis) or triangles (mesh axis)
  std::vector<double> costs;  ///< ms
  PowerLaw law;
};

/// The exponent that a cost should have, within scaling_tolerance.
double target_exponent(ScalingAxis axis);
constexpr double scaling_tolerance = 0.05;
bool on_target(const Scaling& scaling);

/// The name of an axis' size, "vertices that the stroke reaches".
std::string_view size_name(ScalingAxis axis);

/// The scalings along each axis with at least two sizes: of the time of all events and ends, median over
/// repeats; along the mesh axis also of slow events and of ends alone, which hardly show in the sum.
std::vector<Scaling> scalings(const SuiteResult& result);

Json scalings_json(const std::vector<Scaling>& scalings);

}  // namespace burin
