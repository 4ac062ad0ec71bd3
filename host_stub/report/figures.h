#pragma once
#include <burin/host/percentile.h>

#include "system/console.h"

namespace burin {

/// Of seconds.
Percentiles in_milliseconds(const Percentiles& seconds);

/// p50, p95, p99 and max, in their unit.
Json percentiles_json(const Percentiles& percentiles);

}  // namespace burin
