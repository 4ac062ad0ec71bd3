// Writes percentiles, which every report shows in milliseconds.
#include "report/figures.h"

#include <nlohmann/json.hpp>

namespace burin {

Percentiles in_milliseconds(const Percentiles& seconds) {
  return {1e3 * seconds.p50, 1e3 * seconds.p95, 1e3 * seconds.p99, 1e3 * seconds.max};
}

Json percentiles_json(const Percentiles& percentiles) {
  return {
      {"p50", percentiles.p50}, {"p95", percentiles.p95}, {"p99", percentiles.p99}, {"max", percentiles.max}};
}

}  // namespace burin
