#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "bench/power_law.h"
#include "bench/result.h"

namespace burin {

/// How one cost grows along one axis of a suite.
struct Scaling {
  ScalingAxis axis = ScalingAxis::none;
  std::string cost;  ///< "stroke", "event p95" or "stroke end p50"
  std::vector<std::string> cases;
  std::vector<double> sizes;  ///< region: vertices that the stroke reaches; mesh: triangles
  std::vector<double> costs;  ///< ms
  PowerLaw law;
};

/// The exponent that cost should have, with the tolerance that scaling_tolerance tells.
double target_exponent(ScalingAxis axis);
constexpr double scaling_tolerance = 0.05;
bool on_target(const Scaling& scaling);

/// "vertices that the stroke reaches".
std::string_view size_name(ScalingAxis axis);

/// For each axis along which the result has at least two sizes: of all events and ends of the strokes, median
/// of the repeats; along the mesh axis also of the slow events and of the calls that end a stroke alone,
/// which hardly show in the sum.
std::vector<Scaling> scalings(const SuiteResult& result);

Json scalings_json(const std::vector<Scaling>& scalings);

}  // namespace burin
