#pragma once
#include <burin/host/percentile.h>

#include <vector>

#include "bench/paper/stopwatch.h"

namespace burin::kernels {

/// Wall time of a call.
template <class Body>
double seconds_of(const Body& body) {
  paper::Stopwatch watch;
  body();
  return watch.lap();
}

inline double median(const std::vector<double>& values) { return percentiles(values).p50; }

/// Of a median of seconds over `items` of something.
inline double nanoseconds_each(const std::vector<double>& seconds, double items) {
  return 1e9 * median(seconds) / items;
}

}  // namespace burin::kernels
