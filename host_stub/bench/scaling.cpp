// Fits the growth of costs: the cases of a suite that share an axis give the sizes and costs of one power
// law.
#include "bench/scaling.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

struct Measure {
  ScalingAxis axis;
  const char* cost;
  double (*of)(const CaseResult&);  ///< ms
};

double stroke_ms(const CaseResult& one) { return 1e3 * percentiles(one.stroke_seconds).p50; }
double slow_event_ms(const CaseResult& one) { return one.event.whole.at.p95; }
double end_ms(const CaseResult& one) { return one.end.whole.at.p50; }

constexpr Measure measures[] = {{ScalingAxis::region, "stroke", stroke_ms},
                                {ScalingAxis::mesh, "stroke", stroke_ms},
                                {ScalingAxis::mesh, "event p95", slow_event_ms},
                                {ScalingAxis::mesh, "stroke end p50", end_ms}};

Scaling scaling_of(const Measure& measure, const SuiteResult& result) {
  Scaling scaling;
  scaling.axis = measure.axis;
  scaling.cost = measure.cost;
  for (const CaseResult& one : result.cases) {
    if (one.axis != measure.axis) continue;
    scaling.cases.push_back(one.name);
    scaling.sizes.push_back(one.counter(measure.axis == ScalingAxis::region ? "region" : "triangles"));
    scaling.costs.push_back(measure.of(one));
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
  for (const Measure& measure : measures) {
    Scaling scaling = scaling_of(measure, result);
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
                   {"cost", scaling.cost},
                   {"cases", scaling.cases},
                   {"sizes", scaling.sizes},
                   {"cost_ms", scaling.costs},
                   {"exponent", scaling.law.exponent},
                   {"standard_error", scaling.law.standard_error},
                   {"target", target_exponent(scaling.axis)},
                   {"tolerance", scaling_tolerance},
                   {"on_target", on_target(scaling)}});
  }
  return all;
}

}  // namespace burin
