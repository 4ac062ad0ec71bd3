#include "bench/scaling.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

Scaling along(ScalingAxis axis, const SuiteResult& result) {
  Scaling scaling;
  scaling.axis = axis;
  for (const CaseResult& one : result.cases) {
    if (one.axis != axis) continue;
    scaling.cases.push_back(one.name);
    scaling.sizes.push_back(one.counter(axis == ScalingAxis::region ? "region" : "triangles"));
    scaling.costs.push_back(percentiles(one.stroke_seconds).p50);
  }
  return scaling;
}

bool sizes_differ(const Scaling& scaling) {
  return std::adjacent_find(scaling.sizes.begin(), scaling.sizes.end(), std::not_equal_to<>()) !=
         scaling.sizes.end();
}

}  // namespace

double target_exponent(ScalingAxis axis) { return axis == ScalingAxis::region ? 1 : 0; }

bool on_target(const Scaling& scaling) {
  return std::abs(scaling.law.exponent - target_exponent(scaling.axis)) <= scaling_tolerance;
}

std::string_view size_name(ScalingAxis axis) {
  return axis == ScalingAxis::region ? "vertices that the stroke reaches" : "triangles of the surface";
}

std::vector<Scaling> scalings(const SuiteResult& result) {
  std::vector<Scaling> all;
  for (const ScalingAxis axis : {ScalingAxis::region, ScalingAxis::mesh}) {
    Scaling scaling = along(axis, result);
    if (!sizes_differ(scaling)) continue;
    scaling.law = fit_power_law(scaling.sizes, scaling.costs);
    all.push_back(std::move(scaling));
  }
  return all;
}

Json scalings_json(const std::vector<Scaling>& scalings) {
  Json all = Json::array();
  for (const Scaling& scaling : scalings) {
    all.push_back({{"axis", scaling.axis == ScalingAxis::region ? "region" : "mesh"},
                   {"cases", scaling.cases},
                   {"sizes", scaling.sizes},
                   {"cost_s", scaling.costs},
                   {"exponent", scaling.law.exponent},
                   {"standard_error", scaling.law.standard_error},
                   {"target", target_exponent(scaling.axis)},
                   {"tolerance", scaling_tolerance},
                   {"on_target", on_target(scaling)}});
  }
  return all;
}

}  // namespace burin
