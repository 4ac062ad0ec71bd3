#pragma once
#include <burin/host/percentile.h>

#include "system/console.h"

namespace burin {

/// Converts percentiles from seconds to milliseconds.
Percentiles in_milliseconds(const Percentiles& seconds);

/// The percentiles p50, p95, p99 and max as JSON, in their unit.
Json percentiles_json(const Percentiles& percentiles);

}  // namespace burin
